/// The look of a report: a column of text of a readable width, light or dark as the reader has it, tables
/// that fold on a narrow screen. Pictures keep the white of paper.
#pragma once

#include <string_view>

namespace asperity::report {

inline constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --paper: #fcfcfb; --ink: #1c2024; --soft: #5d666f; --line: #d9dde1; --card: #ffffff;
  --accent: #0b5f93; --alarm: #9b1c1c; --alarm-paper: #fdecea; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181b; --ink: #e4e7ea; --soft: #9aa4ae; --line: #343a41; --card: #1d2125; --accent: #7cc0ee;
    --alarm: #ffb4ab; --alarm-paper: #42191a; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; max-width: 72rem; padding: 2rem clamp(1rem, 4vw, 3rem) 3rem; background: var(--paper);
  color: var(--ink); font: 1rem/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
h1 { font-size: clamp(1.5rem, 5vw, 2.1rem); line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.6rem 0 .8rem; padding-bottom: .3rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.6rem 0 .5rem; color: var(--accent); }
p { margin: .4rem 0; max-width: 46rem; }
.soft, footer, table span { color: var(--soft); }
.warning { margin: 1.2rem 0; padding: .8rem 1rem; max-width: none; border-left: .35rem solid var(--alarm);
  background: var(--alarm-paper); color: var(--alarm); font-weight: 600; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(9rem, 1fr)); gap: .8rem; margin: 1.4rem 0 0; }
.tiles div { background: var(--card); border: 1px solid var(--line); border-radius: .5rem; padding: .7rem .9rem; }
.tiles dt { color: var(--soft); font-size: .85rem; }
.tiles dd { margin: 0; font-size: 1.35rem; font-variant-numeric: tabular-nums; }
.pictures { columns: 26rem 2; column-gap: 1rem; }
figure { break-inside: avoid; max-width: 40rem; margin: 0 0 1rem; padding: .6rem .6rem .5rem; background: #ffffff; color: #1c2024; border: 1px solid var(--line);
  border-radius: .5rem; }
figure img { display: block; width: 100%; height: auto; }
figcaption { font-size: .9rem; padding: .3rem .4rem 0; color: #3b434b; }
table { border-collapse: collapse; width: 100%; font-size: .95rem; }
th, td { text-align: left; vertical-align: baseline; padding: .35rem .6rem; border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-weight: 500; font-size: .85rem; }
tbody th { font-weight: 400; }
tbody th b { font-weight: 600; margin-right: .35em; }
table span { font-size: .88rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.measurements thead th:nth-child(n+2):nth-child(-n+4), .results thead th:nth-child(n+2) { text-align: right; }
.unit { white-space: nowrap; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 19rem), 1fr)); column-gap: 2rem; margin: 0; }
dl div { display: flex; justify-content: space-between; gap: 1rem; padding: .3rem 0; border-bottom: 1px solid var(--line); }
dl.tiles div { display: block; }
dt { color: var(--soft); font-size: .95rem; }
dd { margin: 0; text-align: right; overflow-wrap: anywhere; font-variant-numeric: tabular-nums; font-size: .95rem; }
dl.tiles dd { text-align: left; }
dd.short { white-space: nowrap; }
details { margin: .8rem 0; }
summary { cursor: pointer; color: var(--accent); }
.history { padding-left: 1.4rem; }
.history li { margin: .5rem 0; }
time { display: block; color: var(--soft); font-size: .85rem; }
code { overflow-wrap: anywhere; font: .88rem/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
footer { margin-top: 3rem; font-size: .85rem; border-top: 1px solid var(--line); padding-top: .6rem; }
@media (max-width: 44rem) {
  .measurements thead { display: none; }
  .measurements tr { display: grid; grid-template-columns: 1fr auto auto auto; column-gap: .35rem; padding: .45rem 0;
    border-bottom: 1px solid var(--line); align-items: baseline; }
  .measurements th, .measurements td { border: 0; padding: 0; }
  .measurements tbody th { grid-row: 1 / span 2; padding-right: .6rem; }
  .measurements tbody th span { display: block; }
  .measurements td.interval { grid-row: 2; grid-column: 2 / -1; color: var(--soft); font-size: .88rem; }
  .measurements td.error:not(:empty)::before { content: "± "; }
  .measurements td:empty { display: none; }
  .results thead { display: none; }
  .results tr { display: grid; grid-template-columns: 1fr auto; column-gap: .6rem; padding: .45rem 0;
    border-bottom: 1px solid var(--line); align-items: baseline; }
  .results th, .results td { border: 0; padding: 0; }
  .results tbody th { grid-row: 1 / span 3; }
  .results td { grid-column: 2; }
  .results td.smooth:not(:empty)::before { content: "smooth "; }
  .results td.ratio:not(:empty)::before { content: "ratio "; }
  .results td.smooth, .results td.ratio { color: var(--soft); font-size: .88rem; }
  .contents th, .contents td { padding: .35rem .25rem; }
  .results th span, .contents th span { display: block; }
  dl.tiles dd { font-size: 1.1rem; }
}
@media print { body { max-width: none; padding: 0; } figure, tr { break-inside: avoid; } }
)css";

}  // namespace asperity::report
