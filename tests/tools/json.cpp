#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity::test;

// python3-jsonschema judges; where it is missing nothing is claimed.
TEST_CASE("all that tools print with --json and --report is of the schema", "[json][contract][slow]") {
  const Outcome made = shell(
      "mkdir json; cd json; asperity-generate --shape 48x48 --size 3mm --rq 0.4um --length 6px --seed 3 "
      "--report generate.json -o "
      "s.nc &&"
      "asperity-kernel --length 4px --report kernel.json -o k.nc &&"
      "asperity-stats s.nc --parameters all --json > stats.json && cp s.nc t.nc && asperity-stats s.nc t.nc "
      "--json > "
      "several.json &&"
      "asperity-acf s.nc --result profiles --json > acf.json && asperity-acf s.nc --result lengths --json > "
      "lengths.json && "
      "asperity-psd s.nc --result profiles --json > psd.json &&"
      "asperity-psd s.nc --result radial --json > radial.json && asperity-pdf s.nc --json > pdf.json &&"
      "asperity-validate s.nc --significance 1e-9 --json > validate.json &&"
      "asperity-filter s.nc --crop 0:1,0:48 -o row.nc && asperity-stats row.nc --parameters all --json > "
      "row.json 2> /dev/null;"  // without slopes, and of few independent heights
      "press='asperity-contact --radius 50mm --young 208GPa --poisson 0.3';"
      "$press --load 50N --report contact.json s.nc -o p.nc && $press --sweep 10N,20N --json s.nc > "
      "loads.json &&"
      "asperity-stress p.nc --maximum --report stress.json -o v.nc && echo 0 0 1um > places &&"
      "asperity-stress p.nc --points places --json > points.json; ls *.json | wc -l");
  INFO(made.error);
  REQUIRE(made.out == "15\n");
  const Outcome judged = shell(
      "cd json; python3 -c 'import jsonschema' 2>/dev/null || { echo SKIPPED: there is no "
      "python3-jsonschema; exit; };"
      "cat > judge.py <<'PY'\n"
      "import json, sys, jsonschema\n"
      "judge = jsonschema.Draft202012Validator(json.load(open(sys.argv[1])))\n"
      "for name in sys.argv[2:]:\n"
      "    for fault in judge.iter_errors(json.load(open(name))): print(name, fault.message[:200])\n"
      "print(*(n for n, text in enumerate(['{}', '[]', '{\"a\": {\"value\": 1}}', '{\"a\": {\"unit\": \"m\", "
      "\"values\": [1, \"b\"]}}',\n"
      "    '{\"load\": 1}', '{\"a_b\": {}}']) if judge.is_valid(json.loads(text))))\n"
      "PY\n"
      "python3 judge.py " ASPERITY_SCHEMA " *.json");
  if (skipped(judged)) return;
  CAPTURE(judged.error);
  CHECK(judged.out == "\n");  // and none of the counter-examples is valid
}
