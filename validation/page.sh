# Functions with which validation/report writes its pages. A chapter calls
#   heading TITLE, text <<END, run PROGRAM [ARGUMENT...], run_script, table, picture, shown, claim
# `run` stores the tables of a program as results/PROGRAM-1.tsv, -2.tsv, …; the others refer to them by name. In a
# condition on rows, an awk expression, `c["name"]` is the number of the column so named: '$c["N"] >= 256'.

programs=$PWD/build/validation

build() {
  . cmake/packages
  cmake/install-packages $build $run $test
  [ -f build/build.ninja ] || cmake --preset release --log-level=WARNING
  cmake --build --preset release --target validation asperity_tools >&2
}

# begin FOLDER: an empty page FOLDER/RESULTS.md, with chapters, tables and pictures in FOLDER/results.
begin() {
  local present
  present=$(conditions)
  mkdir -p "$1/results"
  rm -f "$1"/results/*
  echo "$present" >"$1/results/conditions.txt"
  [ -z "${apart:-}" ] || printf '\nRan apart, at commit %s: %s.\n' "$(<"$apart/commit")" \
    "$(basename -s .out "$apart"/*.out | paste -sd' ')" >>"$1/results/conditions.txt"
  begin_again "$1"
}

# runs PROGRAM CHAPTER...: whether one of them does.
runs() { grep -qE "^run(_script)? $1( |\$)" "${@:2}"; }

# begin_again FOLDER [PROGRAM...]: the same, with the tables of an earlier run, except those of these programs.
begin_again() {
  index=$1/RESULTS.md results=$1/results former_claims= former_chapters=
  if [ $# -eq 1 ]; then
    rm -f "$results"/*.md
  else
    local program
    for program in "${@:2}"; do runs "$program" validation/chapters/* || { echo "report: no chapter runs $program" >&2; exit 2; }; done
    printf 'Run again at commit %s: %s.\n' "$(commit)" "${*:2}" >>"$results/conditions.txt"
    former_claims=$(<"$results/claims.tsv") former_chapters=$(<"$results/chapters.txt")
  fi
  printf 'claim\tworst\tbound\tcases\tholds\tchapter\n' >"$results/claims.tsv"
  : >"$results/chapters.txt"
}

# write_chapter: the page of $chapter; where --again names programs and none of its own, the page of the last run stays, with its
# claims, for the chapter may ask for tables that are not stored.
write_chapter() {
  local name program
  [[ -v again && -n ${again// /} ]] || { . "$chapter"; return; }
  for program in $again; do
    ! runs "$program" "$chapter" || { . "$chapter"; return; }
  done
  name=$(basename "$chapter" .sh)
  awk -F'\t' -v name="${name#*-}" '$6 == name' <<<"$former_claims" >>"$results/claims.tsv"
  awk -F'\t' -v name="${name#*-}" '$1 == name' <<<"$former_chapters" >>"$results/chapters.txt"
}

conditions() {
  cat <<END
# Error against run time, scaling, stability

$(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores; $(. /etc/os-release && echo "$PRETTY_NAME"); \
$("$programs/heights_plane" -1 | sed -n '1s/^# //p').
Compiled with \`$(flags)\`, with $(versions), at commit $(commit).

\`validation/report\` writes this page; the top of each program explains its columns. Seconds are the shortest of at least five
runs; +N % says by how much the median run took longer. On one shared machine two runs of this page differed by up to a factor of two
in all seconds of a table, and by 15 % in the median of its ratios: compare ratios. \`r2c\` is one real-to-complex transform by FFTW,
timed in the same run. \`validation/report --same\` checks that all else is the same in every run.
END
}

commit() { git describe --always --dirty --exclude '*' 2>/dev/null || echo unknown; }
# Flags of the compiler, without paths and warnings.
flags() { sed -n 's/^ *FLAGS = //p' build/build.ninja | head -1 | tr ' ' '\n' | grep -E '^-(O|D|m|f|std)' | tr '\n' ' ' | sed 's/ $//'; }
versions() {
  dpkg-query -W -f '${Package} ${Version}, ' libgsl-dev libsundials-dev libfftw3-dev libeigen3-dev libnetcdf-dev |
    sed 's/, $//; s/lib\([a-z0-9]*\)-dev/\1/g; s/\(+dfsg\)\?-[^, ]*//g'
}

# A page of its own for each chapter; a second heading is a section there.
heading() {
  local name
  name=$(basename "$chapter" .sh)
  name=${name#*-}
  if [ "${page:-}" = "$results/$name.md" ]; then
    printf '\n## %s\n' "$1" >>"$page"
    return
  fi
  page=$results/$name.md pictured=
  printf '# %s\n\nA chapter of the [results](../RESULTS.md).\n' "$1" >"$page"
  printf '%s\t%s\n' "$name" "$1" >>"$results/chapters.txt"
}
text() { { echo; cat; } >>"$page"; }

# wanted PROGRAM: whether to run it, that is, unless --again names other programs only.
wanted() { [[ ! -v again || $again == *" $1 "* ]]; }

# run PROGRAM[@NAME] [ARGUMENT...]: runs it, unless it ran apart, and stores its tables.
run() {
  local start=$SECONDS
  wanted "$1" || return 0
  if [ -f "${apart:-}/$1.out" ]; then cp "$apart/$1.out" "$results"; else "$programs/${1%@*}" "${@:2}" >"$results/$1.out"; fi
  awk -F'\t' -v to="$results/$1" '
    /^# .*\t/ { close(file); file = to "-" ++tables ".tsv"; sub(/^# /, ""); print >file; next }
    /^#/ || NF < 2 || !file { next }
    { print >file }' "$results/$1.out"
  rm "$results/$1.out"
  echo "$*: $((SECONDS - start)) s" >&2
}

# run_script NAME COMMAND...: the same of a script that writes tables.
run_script() {
  wanted "$1" || return 0
  local programs=$results
  printf '#!/bin/sh\nexec %s\n' "${*:2}" >"$results/$1"
  chmod +x "$results/$1"
  run "$1"
  rm "$results/$1"
}

# rows TABLE [CONDITION]: its header and these rows.
rows() {
  [ -f "$results/$1.tsv" ] || { echo "report: the last run has no table $1: run its program, --again ${1%-*}" >&2; return 1; }
  awk -F'\t' 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; print; next } '"${2:-1}" "$results/$1.tsv"
}

# table TABLE [CONDITION [COLUMN...]]: COLUMN_spread stands behind COLUMN, in per cent.
table() {
  {
    echo
    rows "$1" "${2:-1}" | awk -F'\t' -v columns="${*:3}" '
      NR == 1 {
        wanted = split(columns, name, " ")
        for (i = 1; i <= NF; ++i) { c[$i] = i; if (!columns && $i !~ /_spread$/) name[++wanted] = $i }
        for (k = 1; k <= wanted; ++k) { line = line "| " name[k] " "; rule = rule "|---" }
        print line "|\n" rule "|"
        next
      }
      {
        for (k = 1; k <= wanted; ++k) {
          value = $c[name[k]]
          spread = name[k] "_spread"
          if (spread in c && $c[spread] != "" && value > 0) value = value sprintf(" +%.0f %%", 100 * $c[spread])
          printf "| %s ", value
        }
        print "|"
      }' | sed '1s/_/ /g'
  } >>"$page"
}

# picture NAME CAPTION <<END: gnuplot's commands, after those that all pictures share; `data TABLE` is a file name.
picture() {
  {
    cat <<'END'
set terminal pngcairo size 760,420 font 'DejaVu Sans,10' background rgb 'white'
set datafile separator tab
set datafile missing NaN
set logscale xy
set format xy '10^{%L}'
set xlabel 'seconds'
set key outside right top samplen 2
set for [i=1:9] linetype i linecolor rgb word('#0060ad #dd181f #2ca02c #8c4fb0 #e08000 #00a0b0 #8c6d31 #404040 #e377c2', i)
set grid linetype 1 linecolor rgb '#d8d8d8'
set pointsize 0.8
END
    sed "s|@|$results/|g"
  } | gnuplot 2>&1 >"$results/$1.png" | { grep -v 'no valid points' >&2 || true; }
  shown "$1" "$2"
}

# shown NAME CAPTION: a picture that exists. The first of a chapter stands in RESULTS.md too.
shown() {
  printf '\n![%s](%s.png)\n' "$2" "$1" >>"$page"
  [ -z "$pictured" ] || return 0
  pictured=$1
  sed -i "\$s|$|\t$1\t$2|" "$results/chapters.txt"
}

# awk's functions for claims.
functions='
  function abs(x) { return x < 0 ? -x : x }
  function least(a, b) { return a < b ? a : b }'

# tightest TABLE CONDITION EXPRESSION: of the comparisons in the expression, joined by &&, and of the rows, the one that holds by
# the smallest share of its bound: value, bound, and the number of rows.
tightest() {
  local program= clause sign
  while IFS= read -r clause; do
    [[ $clause =~ ^(.*)\ (<=|>=|<|>)\ (.*)$ ]] || continue
    [[ ${BASH_REMATCH[2]} == ">"* ]] && sign=-1 || sign=1
    program+="{
      l = (${BASH_REMATCH[1]}); r = (${BASH_REMATCH[3]}); m = $sign * (r - l) / (abs(r) + 1e-300)
      if (!n++ || m < best) { best = m; value = l; bound = r; op = \"${BASH_REMATCH[2]}\" }
    }"$'\n'
  done < <(sed 's/ && /\n/g' <<<"$3")
  rows "$1" "$2" | awk -F'\t' "$functions"'
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    { ++cases }
    '"$program"'
    END {
      sub("<=", "≤", op); sub(">=", "≥", op)
      if (n) printf "%.2g\t%s %.3g\t%d\n", value, op, bound, cases; else printf "\t\t%d\n", cases
    }'
}

# claim SENTENCE TABLE CONDITION EXPRESSION: at least one row meets the condition, and the expression is true in each row that
# does. It may use abs(x) and least(x, y).
claim() {
  local failing holds=yes
  failing=$(rows "$2" "$3" | awk -F'\t' "$functions"'
    NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    { ++seen }
    !('"$4"') || /(^|\t)-?nan/ { print }
    END { if (!seen) print "no row" }')
  if [ -z "$failing" ]; then
    printf '\n✓ %s\n' "$1" >>"$page"
  else
    printf '\n**Does not hold:** %s\n' "$1" >>"$page"
    printf 'report: does not hold: %s\n%s\n' "$1" "$failing" >&2
    holds=no
  fi
  printf '%s\t%s\t%s\t%s\n' "$1" "$(tightest "$2" "$3" "$4")" "$holds" "$(basename "$page" .md)" >>"$results/claims.tsv"
}

# RESULTS.md: all claims in one table, and of each chapter its first picture.
finish() {
  local held broken
  held=$(awk -F'\t' '$5 == "yes"' "$results/claims.tsv" | wc -l)
  broken=$(awk -F'\t' '$5 == "no"' "$results/claims.tsv" | wc -l)
  {
    cat "$results/conditions.txt"
    printf '\n## Claims\n\n`worst` is the value nearest to its bound among so many `cases`.\n\n'
    echo '| claim | worst | bound | cases | chapter |'
    echo '|---|---|---|---|---|'
    awk -F'\t' 'NR > 1 {
      printf "| %s%s | %s | %s | %s | [%s](results/%s.md) |\n", $5 == "yes" ? "" : "**does not hold:** ", $1, $2, $3, $4, $6, $6
    }' "$results/claims.tsv"
    printf '\n## What surprised\n\n'
    cat validation/surprises.md
    printf '\n## Chapters\n'
    awk -F'\t' '{
      printf "\n**[%s](results/%s.md)**\n", $2, $1
      if ($3) printf "\n![%s](results/%s.png)\n", $4, $3
    }' "$results/chapters.txt"
  } >"$index"
  echo "$index: $held claims hold, $broken do not; ${SECONDS} s" >&2
  [ "$broken" -eq 0 ]
}
