"""Opens a report in Chromium, points, moves a slider, copies a table, prints; writes what it saw as JSON."""

import html
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TRY = """
<script>
(async () => {
  const out = {}, of = s => document.querySelector(s), text = s => of(s).textContent;
  const pause = ms => new Promise(done => setTimeout(done, ms));
  const point = (target, x, y, buttons = 0) => {
    const box = target.getBoundingClientRect();
    const at = { clientX: box.left + x, clientY: box.top + y, buttons };
    target.dispatchEvent(new PointerEvent('pointermove', at));
  };
  try {
    for (let k = 0; k < 100 && !text('.readout'); ++k) await pause(50);
    for (const folded of document.querySelectorAll('details')) folded.open = true;
    out.width = [innerWidth, document.documentElement.scrollWidth];
    out.start = text('.readout');
    const f = of('.map').frame;
    point(of('.map'), f.left + f.width - .01, f.top + .01);
    out.corner = text('.readout');
    const slider = of('.viewer .y');
    slider.value = 0;
    slider.dispatchEvent(new Event('input'));
    const label = of('.profile').getAttribute('aria-label');
    out.slid = [text('.readout'), slider.getAttribute('aria-valuetext'), label];
    const deep = of('.below').frame;
    point(of('.below'), deep.left + .01, deep.top + deep.height);
    out.below = text('.readout');
    const which = of('.which');
    which.selectedIndex = 1;
    which.dispatchEvent(new Event('change'));
    await pause(500);
    out.second = text('.readout');
    const curve = of('svg[data-key][aria-label^=Autocorrelation]'), whole = curve.getBoundingClientRect();
    const panel = curve.querySelector('.panel').getBoundingClientRect();
    point(curve, panel.left - whole.left, panel.top - whole.top + 3);
    out.curve = curve.closest('figure').querySelector('output').textContent;
    out.table = table_text(of('.measurements'));
    out.still = getComputedStyle(of('.still')).display;
  } catch (error) { out.error = String(error.stack); }
  const result = document.createElement('pre');
  result.id = 'result';
  result.textContent = JSON.stringify(out);
  document.body.append(result);
  if (parent !== window) parent.postMessage(result.textContent, '*');
})();
</script>
</body>"""
# Chromium's windows are at least 500 pixels wide.
NARROW = """<!DOCTYPE html><iframe src="page.html" style="border: 0; width: 320px; height: 800px"></iframe>
<pre id="result"></pre>
<script>onmessage = event => { document.querySelector('pre').textContent = event.data; };</script>"""


def chromium(page, *arguments):
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", *arguments]
    run = subprocess.run(["chromium", *options, page.as_uri()], capture_output=True, timeout=120, check=False)
    return run.stdout.decode()


def tried(page):
    dom = chromium(page, "--window-size=1200,800", "--virtual-time-budget=20000", "--dump-dom")
    return json.loads(html.unescape(re.search(r'<pre id="result">(.+?)</pre>', dom, re.S)[1]))


def pages_of(page):
    pdf = page.with_suffix(".pdf")
    chromium(page, f"--print-to-pdf={pdf}")
    return len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf.read_bytes()))


def main():
    if not shutil.which("chromium"):
        print("SKIPPED: no chromium")
        return
    original = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.html"
        page.write_text(original.read_text(encoding="utf-8").replace("</body>", TRY), encoding="utf-8")
        frame = Path(folder) / "frame.html"
        frame.write_text(NARROW, encoding="utf-8")
        print(json.dumps({"wide": tried(page), "narrow": tried(frame), "pages": pages_of(page)}))


main()
