// SPDX-License-Identifier: MIT
#include "page_text.hpp"

namespace shigusa {

const std::string_view kPageStyle = R"css(
:root{color-scheme:light dark;--page:#f3f4f5;--panel:#fff;--text:#1c2226;--quiet:#56626b;--line:#dde1e4;
--accent:#1f6f6a;--good:#1d7a4f;--hard:#855500;--bad:#b3233a;--bar:#c8553d;
--left:#a9b8c5;--right:#7c92a6;--middle:#90a4b5;--acting:#cf5f45;--goal:#e07a1f;--floor:#eef0f2;--ring:#d3d9de;
--shadow:#1c222633;--sole:#2f8f6b;--box:#8a94a066;--way:#e07a1f}
@media (prefers-color-scheme:dark){:root{--page:#14181b;--panel:#1c2125;--text:#e8ecee;--quiet:#a3afb7;--line:#30383e;
--accent:#6fc9c0;--good:#66cf9b;--hard:#f0bb5c;--bad:#ff8a99;--bar:#e0765c;
--left:#8394a3;--right:#b3c3d0;--middle:#9badbc;--acting:#ea7b60;--goal:#ff9f5e;--floor:#252b30;--ring:#3a444b;
--shadow:#0009;--sole:#58c79b;--box:#aeb9c44d;--way:#ff9f5e}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--text);font:15px/1.5 system-ui,sans-serif}
header,main,footer{max-width:1240px;margin:0 auto;padding:0 16px}
header{padding-top:24px}
footer{padding-bottom:40px}
h1{font-size:1.6rem;line-height:1.25;margin:0 0 4px;overflow-wrap:anywhere}
h2{font-size:1.25rem;line-height:1.3;margin:0 0 4px;overflow-wrap:anywhere}
h3{font-size:1rem;line-height:1.35;margin:8px 0 2px;overflow-wrap:anywhere}
p{margin:2px 0 8px;overflow-wrap:anywhere}
nav ul{list-style:none;margin:8px 0 0;padding:0;display:flex;flex-wrap:wrap;gap:4px 18px}
a{color:var(--accent)}
.result{margin:32px 0 0}
.quiet,footer,summary,th{color:var(--quiet)}
.controls{display:flex;align-items:center;gap:8px;margin:10px 0}
button{font:inherit;color:var(--text);background:var(--panel);border:1px solid var(--line);border-radius:8px;min-height:38px;padding:4px 14px;cursor:pointer}
button.play{min-width:84px}
button:focus-visible,input:focus-visible,summary:focus-visible,a:focus-visible{outline:2px solid var(--accent);outline-offset:2px}
button.turn{min-width:40px;padding:4px 8px}
input[type=range]{flex:1 1 60px;min-width:60px;max-width:340px;min-height:38px;accent-color:var(--accent)}
.time{font-variant-numeric:tabular-nums;min-width:3.6em;text-align:right;color:var(--quiet);white-space:nowrap}
.candidates{list-style:none;margin:0;padding:0;display:grid;gap:12px;grid-template-columns:repeat(auto-fill,minmax(min(100%,300px),1fr))}
.candidates>li{background:var(--panel);border:1px solid var(--line);border-radius:12px;padding:10px 14px 12px;min-width:0}
canvas{display:block;width:100%;aspect-ratio:1/1;cursor:grab;touch-action:pan-y}
canvas.turning{cursor:grabbing}
.rank{display:inline-block;min-width:1.6em;margin-right:6px;padding:0 .4em;border-radius:1em;background:var(--line);text-align:center;font-variant-numeric:tabular-nums}
.verdict{font-weight:600;margin:2px 0}
.possible{color:var(--good)}.strains{color:var(--hard)}.impossible{color:var(--bad)}
.reasons{margin:0 0 8px;padding-left:1.2em;font-size:.9rem}
.costs{list-style:none;margin:4px 0 8px;padding:0;font-size:.9rem}
.costs li{margin:0 0 5px}
.costs span{display:block;border-radius:3px;background:var(--line)}
.costs i{display:block;height:5px;border-radius:3px;background:var(--bar);min-width:3px}
.label{font-size:.86rem;color:var(--quiet);margin:6px 0 0}
details{font-size:.86rem}
summary{cursor:pointer;min-height:28px}
table{border-collapse:collapse;width:100%;margin:4px 0}
th,td{font-weight:400;text-align:left;padding:1px 0;vertical-align:top;overflow-wrap:anywhere}
td{text-align:right;font-variant-numeric:tabular-nums;padding-left:10px}
@media (max-width:480px){header,main,footer{padding-left:12px;padding-right:12px}}
@media print{.controls{display:none}.candidates>li{break-inside:avoid}}
)css";

}  // namespace shigusa
