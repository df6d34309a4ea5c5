# Compares the numbers of two runs of validation/report.

# Columns with times or memory, by table, each with its _spread; all other columns are the same in each run.
measured='
acf_error_time-1 seconds ratio
acf_error_time-2 seconds ratio
acf_error_time-3 seconds
chain_error_time-1 setup seconds draw contact stress
contact_grid_error-2 share
contact_error_time-1 setup_seconds seconds over_operators convolution_over_r2c
contact_error_time-2 setup_seconds seconds over_operators
flow_error_time-1 seconds
flow_error_time-2 seconds
flow_scene-1 seconds
heights_error_time-1 fit solve surface whole
heights_plane-1 fit apply map
moments_error_time-1 seconds ratio
ranks_time-1 seconds ratio MB share
scaling-1 seconds transforms MB doubles
scaling-2 exponent time memory largest hours
scene_time-1 kernel draw contact stress sum share
stress_edge-2 seconds
stress_error_time-1 setup_seconds seconds ratio_to_padded_r2c
stress_error_time-2 seconds_full seconds_adapted
stress_request_time-1 first cpu wall MB r2c
synthesis_time-1 peak
synthesis_time-2 noise transforms surface surface_2 ratio
synthesis_time-3 direct transform ratio
synthesis_time-4 kernel surface
tool_time-1 tool library ratio fields
twins-2 seconds
twins-3 seconds processor fields
'

# lasting FOLDER TABLE: the table without these columns.
lasting() {
  awk -F'\t' -v measured="$(sed -n "s/^$2 //p" <<<"$measured")" '
    BEGIN { split(measured, names, " "); for (k in names) left_out[names[k]] = left_out[names[k] "_spread"] = 1 }
    NR == 1 { for (i = 1; i <= NF; ++i) if (!($i in left_out)) kept[++n] = i }
    { for (k = 1; k <= n; ++k) printf "%s%s", $kept[k], k < n ? "\t" : "\n" }' "$1/results/$2.tsv"
}

# same FOLDER FOLDER: prints the differences, and fails if there is one.
same() {
  local table picture differing=0
  for table in "$1"/results/*.tsv; do
    table=$(basename "$table" .tsv)
    diff --label "$1: $table" --label "$2: $table" -u0 <(lasting "$1" "$table") <(lasting "$2" "$table") || differing=1
  done
  for picture in "$1"/results/{paper,flow}-*.png; do cmp "$picture" "$2/results/$(basename "$picture")" || differing=1; done
  return "$differing"
}
