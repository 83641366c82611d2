"""How the page looks: light and dark, on a phone, on paper."""

# The teams' blue and orange keep apart for every kind of colour blindness. Letters on a verdict's
# colour have a contrast of 4.5 at least.
STYLE = """
:root { color-scheme: light dark;
  --paper: #fbfbfa; --card: #ffffff; --ink: #1d2329; --faint: #5c6773; --line: #d9dee3;
  --blue: #1f6fc4; --orange: #d9680b; --even: #8b96a2; --same: #c3cad1;
  --for: #1f6fc414; --against: #d9680b14; --band: #1f6fc433; --link: #0b5cad;
  --pass: #1a7f45; --fail: #c62828; --inconclusive: #8a6100; --identical: #52606d;
  --invalid: #7b2d8b;
  --ll: #b3541e; --ld: #e5a36f; --dd: #c3cad1; --dw: #86b4e3; --ww: #1f6fc4 }
@media (prefers-color-scheme: dark) { :root {
  --paper: #14181d; --card: #1c2229; --ink: #e6eaee; --faint: #9aa7b4; --line: #333d47;
  --blue: #5aa5f0; --orange: #f2914a; --even: #7d8996; --same: #4a5663;
  --for: #5aa5f01a; --against: #f2914a1a; --band: #5aa5f040; --link: #82bdf7;
  --pass: #1e7d46; --fail: #c23434; --inconclusive: #8a6510; --identical: #56646f;
  --invalid: #84389a;
  --ll: #c96a2d; --ld: #8d5a35; --dd: #4a5663; --dw: #3a5f86; --ww: #5aa5f0 } }
* { box-sizing: border-box }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 66rem; margin: 0 auto; padding: 1rem 1rem 3rem; overflow-wrap: anywhere }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem }
h3 { font-size: 1rem; margin: 0 0 .3rem } p { margin: .35rem 0 } a { color: var(--link) }
.verdict { color: #fff; border-radius: 10px; padding: 1.1rem 1.3rem; background: var(--identical);
  print-color-adjust: exact; -webkit-print-color-adjust: exact }
.verdict p { font-size: 1.1rem } .verdict .why { font-size: 1rem }
.pass { background: var(--pass) } .fail { background: var(--fail) }
.inconclusive { background: var(--inconclusive) } .invalid { background: var(--invalid) }
.sign { display: inline-block; min-width: 1.3em } .faint, figcaption, small { color: var(--faint) }
.warnings { border-left: 4px solid var(--orange); background: var(--card); margin: .8rem 0;
  padding: .5rem 1rem; list-style: none }
.numbers { display: grid; grid-template-columns: repeat(auto-fit, minmax(14rem, 1fr)); gap: .7rem;
  margin: 1rem 0 }
.numbers div, figure { background: var(--card); border: 1px solid var(--line); border-radius: 8px;
  padding: .7rem .9rem; margin: 0 }
.numbers dt { font-size: .85rem; color: var(--faint) } .numbers dd { margin: 0; font-size: .9rem }
.numbers dd.large { font-size: 1.55rem; line-height: 1.3; font-variant-numeric: tabular-nums }
.widest { display: grid; grid-template-columns: repeat(auto-fill, minmax(14rem, 1fr)); gap: .7rem }
.widest > div { border-left: 3px solid var(--line); padding-left: .7rem; font-size: .9rem }
.swatch { display: inline-block; width: .8em; height: .8em; border-radius: 2px; margin-right: .4em;
  print-color-adjust: exact; -webkit-print-color-adjust: exact }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr));
  gap: .7rem }
figcaption { font-size: .85rem; margin-top: .4rem }
svg { display: block; width: 100%; height: auto; max-width: 36rem; margin: 0 auto;
  print-color-adjust: exact; -webkit-print-color-adjust: exact }
svg text { fill: var(--ink); font: 14px system-ui, sans-serif } svg .tick { fill: var(--faint) }
svg .note { font-weight: 600; font-size: 13px }
polyline { fill: none } .grid { stroke: var(--line) } .zero { stroke: var(--faint) }
.bound { stroke: var(--ink); stroke-dasharray: 6 4 }
.closing { stroke: var(--ink); stroke-width: 2 }
.path { stroke: var(--blue); stroke-width: 2; stroke-linejoin: round } .look { fill: var(--blue) }
.mean { stroke: var(--ink); stroke-width: 1.5; stroke-dasharray: 4 4 }
rect.for { fill: var(--for) } rect.against { fill: var(--against) }
rect.clipped { fill: var(--line); opacity: .45 } .band { fill: var(--band) }
rect.plus { fill: var(--blue) } rect.minus { fill: var(--orange) } rect.even { fill: var(--even) }
rect.same { fill: var(--same) }
.ll { fill: var(--ll); background: var(--ll) } .ld { fill: var(--ld); background: var(--ld) }
.dd { fill: var(--dd); background: var(--dd) } .dw { fill: var(--dw); background: var(--dw) }
.ww { fill: var(--ww); background: var(--ww) }
svg.shares { height: 1.1rem; max-width: none; border-radius: 4px; margin: .4rem 0 }
.wide { overflow-x: auto; max-width: 100% }
.tall { max-height: 38rem; overflow: auto; border: 1px solid var(--line); border-radius: 8px }
.tall .wide { overflow: visible }
table { border-collapse: collapse; width: 100%; font-size: .9rem; overflow-wrap: normal;
  font-variant-numeric: tabular-nums }
th, td { padding: .3rem .6rem; border-bottom: 1px solid var(--line); text-align: right;
  vertical-align: top }
thead th { text-align: right; vertical-align: bottom; background: var(--card); font-weight: 600 }
.tall thead th { position: sticky; top: 0 }
th[scope], td.left, th.left { text-align: left } td.left, th[scope] { overflow-wrap: anywhere;
  min-width: 9rem }
td:not(.left) { white-space: nowrap } th.team { min-width: 6.5rem; overflow-wrap: anywhere }
table.counts { max-width: 34rem }
 td.even { color: var(--faint) }
tr.void td { color: var(--faint); font-style: italic }
td.plus { color: var(--blue); font-weight: 600 } td.minus { color: var(--orange); font-weight: 600 }
pre { background: var(--card); border: 1px solid var(--line); border-radius: 8px; margin: .4rem 0;
  padding: .7rem .9rem; overflow-x: auto; font: 13px/1.45 ui-monospace, monospace;
  white-space: pre-wrap }
code { font: .92em ui-monospace, monospace } ul.plain { padding-left: 1.1rem; margin: .4rem 0 }
@media (max-width: 34rem) { body { padding: .6rem .6rem 2rem } h1 { font-size: 1.5rem }
  .verdict { padding: .8rem .9rem } .numbers { grid-template-columns: 1fr 1fr; gap: .5rem }
  .numbers div { padding: .5rem .6rem } .numbers dd.large { font-size: 1.2rem }
  figure { padding: .5rem } th, td { padding: .25rem .4rem } }
@media print { body { font-size: 10.5pt; max-width: none; padding: 0; background: #fff }
  .tall { max-height: none; overflow: visible; border: 0 } .tall thead th { position: static }
  figure, .numbers div, tr, pre { break-inside: avoid } h2 { break-after: avoid }
  .charts { grid-template-columns: 1fr 1fr } }
"""
