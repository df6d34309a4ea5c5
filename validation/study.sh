# The study of Creţu, Bălan & Urzică (2009) with the tools, sourced by ./demo and by the report. A case leaves CASE.nc,
# CASE.surface.nc and the reports of the tools, CASE.kernel.json and so on, in the current folder.

grid=(--shape 128x128 --size 3mm)
bodies=(--radius 50mm,50mm --young 208GPa --poisson 0.3 --load 5000N --yield 1200MPa --tolerance 1e-8)

# press CASE [OPTION...]: contact and stress of a surface, or of --smooth bodies
press() {
  asperity-contact "${@:2}" "${bodies[@]}" --report "$1.contact.json" |
    asperity-stress --depths 0:0.8mm:97 --maximum --report "$1.stress.json" -o "$1.nc"
}

# smooth CASE
smooth() { press "$1" --smooth "${grid[@]}"; }

# rough CASE OPTION...: the same with a rough surface; OPTIONs of asperity-kernel select its autocorrelation
rough() {
  asperity-kernel "${grid[@]}" --rq 0.4um "${@:2}" --report "$1.kernel.json" |
    asperity-generate --kernel - --shape 128x128 --exact-rq --seed 7 --add noise -o "$1.surface.nc" \
      --report "$1.generate.json"
  press "$1" "$1.surface.nc"
}

# figures NAMES CASE...: the figures of the paper, one panel per case; NAMES are comma-separated labels, the first case is smooth
figures() {
  local cases=("${@:2}")
  local pressed=("${cases[@]/%/.nc}" --labels "$1")
  local surfaces=("${cases[@]:1}")
  surfaces=("${surfaces[@]/%/.surface.nc}" --labels "${1#*,}")
  local section=("${pressed[@]}" --kind von-mises --scale-by p0 --section)
  asperity-plot "${surfaces[0]}" --kind surface --variable noise --pixels 900x645 -o noise.png
  asperity-plot "${surfaces[@]}" --kind surface -o surface.png
  asperity-plot "${surfaces[@]}" --kind profile -o profiles.png
  asperity-plot "${surfaces[@]}" --kind acf -o acf.png
  asperity-plot "${surfaces[@]}" --kind pdf -o pdf.png
  asperity-plot "${pressed[@]}" --kind map --variable pressure -o pressure.png
  asperity-plot "${pressed[@]}" --kind contact -o contact.png
  asperity-plot "${section[@]}" y=max -o von-mises.png
  asperity-plot "${section[@]}" y=max --x-range=-1.1mm,1.1mm --depth-range 0mm,0.2mm -o von-mises-surface.png
  asperity-plot "${section[@]}" y=0 --above 0.6p0 --x-range=-1.1mm,1.1mm --depth-range 0mm,0.7mm -o von-mises-detail.png
}
