#include "verify/report_page.h"

#include "film/data_uri.h"
#include "verify/ladder_text.h"

namespace vkpt {
namespace {

constexpr std::string_view kStyle = R"css(
:root { color-scheme: light dark; --ink: #1c2024; --soft: #60646c; --paper: #fcfcfd; --card: #ffffff; --line: #e0e1e6;
        --good: #218358; --bad: #ce2c31; --accent: #0d74ce; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #edeef0; --soft: #b0b4ba; --paper: #111113; --card: #18191b; --line: #363a3f; --good: #3dd68c;
          --bad: #ff9592; --accent: #70b8ff; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { font-size: 24px; margin: 0; } h2 { font-size: 17px; margin: 0 0 12px; }
p { margin: 4px 0; } .soft { color: var(--soft); }
section { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 20px; margin-top: 20px; }
.verdict { border-left: 6px solid var(--good); } .verdict.bad { border-left-color: var(--bad); }
.verdict strong { color: var(--good); font-size: 18px; } .verdict.bad strong { color: var(--bad); }
.verdict pre { white-space: pre-wrap; margin: 10px 0 0; font: 13px/1.5 ui-monospace, monospace; }
.tabs { display: flex; gap: 8px; margin-bottom: 12px; }
.tabs button { font: inherit; padding: 4px 14px; border-radius: 999px; border: 1px solid var(--line); cursor: pointer;
               background: none; color: var(--ink); }
.tabs button[aria-pressed=true] { background: var(--accent); border-color: var(--accent); color: var(--card); }
.slider { position: relative; overflow: hidden; max-width: calc(78vh * var(--ratio)); margin: 0 auto; border-radius: 6px; line-height: 0; touch-action: pan-y; cursor: ew-resize; }
.slider img { width: 100%; image-rendering: pixelated; display: block; user-select: none; -webkit-user-drag: none; }
.slider .over { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at, 50%)); }
.slider .bar { position: absolute; top: 0; bottom: 0; left: var(--at, 50%); width: 2px; background: #fff;
               box-shadow: 0 0 4px #000; }
.slider .tag { position: absolute; top: 10px; padding: 2px 10px; border-radius: 999px; background: #000a; color: #fff;
               font-size: 13px; line-height: 1.5; }
.slider input { position: absolute; inset: 0; width: 100%; height: 100%; opacity: 0; margin: 0; cursor: ew-resize; }
.slider:focus-within .bar { background: var(--accent); }
.heats { display: grid; gap: 20px; grid-template-columns: repeat(auto-fit, minmax(320px, 1fr)); }
.heats img { width: 100%; border-radius: 6px; image-rendering: pixelated; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; color: var(--soft); font-size: 13px; }
td, th { padding: 5px 8px; border-top: 1px solid var(--line); vertical-align: top; }
tr:first-child th { border-top: 0; }
.number { text-align: right; white-space: nowrap; }
.rung td { font-weight: 600; padding-top: 14px; } .rung span { font-weight: 400; color: var(--soft); }
.meter { display: inline-block; width: 72px; height: 7px; border-radius: 4px; background: var(--line); overflow: hidden;
         vertical-align: middle; margin-left: 8px; }
.meter i { display: block; height: 100%; background: var(--accent); }
.good { color: var(--good); } .bad { color: var(--bad); }
details summary { cursor: pointer; white-space: nowrap; } details table { margin: 6px 0 10px; font-size: 13px; }
.scroll { overflow-x: auto; }
.settings td:first-child { color: var(--soft); white-space: nowrap; width: 1%; }
)css";

constexpr std::string_view kScript = R"js(
for (const slider of document.querySelectorAll('.slider')) {
  const range = slider.querySelector('input');
  const move = () => slider.style.setProperty('--at', range.value + '%');
  range.addEventListener('input', move);
  slider.addEventListener('pointermove', e => {
    if (e.buttons === 0 && e.pointerType !== 'mouse') return;
    const box = slider.getBoundingClientRect();
    range.value = 100 * (e.clientX - box.left) / box.width;
    move();
  });
}
for (const tabs of document.querySelectorAll('.tabs')) {
  const buttons = [...tabs.children];
  for (const button of buttons)
    button.addEventListener('click', () => {
      for (const b of buttons) {
        b.setAttribute('aria-pressed', b === button);
        document.getElementById(b.dataset.shows).hidden = b !== button;
      }
    });
}
)js";

std::string escapeHtml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string verdictHtml(const LadderResult& ladder) {
    const bool bad = ladder.failure() != nullptr;
    return fmt::format("<section class=\"verdict{}\"><strong>{}</strong><pre>{}</pre></section>\n", bad ? " bad" : "",
                       bad ? "The renderers disagree" : "The renderers agree", escapeHtml(ladderVerdict(ladder)));
}

std::string slidersHtml(const std::vector<ImagePair>& pairs) {
    std::string tabs, sliders;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const ImagePair& pair = pairs[i];
        tabs += fmt::format("<button data-shows=\"pair{}\" aria-pressed=\"{}\">{}</button>", i, i == 0,
                            escapeHtml(pair.name));
        sliders += fmt::format(
            "<div id=\"pair{}\"{}><div class=\"slider\" style=\"--ratio:{}\"><img alt=\"Vulkan\" src=\"{}\"><div "
            "class=\"over\"><img "
            "alt=\"CPU reference\" src=\"{}\"></div><div class=\"bar\"></div><span class=\"tag\" "
            "style=\"left:10px\">Vulkan</span><span class=\"tag\" style=\"right:10px\">CPU reference</span><input "
            "type=\"range\" min=\"0\" max=\"100\" value=\"50\" step=\"any\" aria-label=\"divider between Vulkan and "
            "CPU "
            "reference\"></div><p class=\"soft\">{}</p></div>\n",
            i, i == 0 ? "" : " hidden", pair.aspect, pngDataUri(pair.device), pngDataUri(pair.reference),
            escapeHtml(pair.about));
    }
    return fmt::format("<section><h2>Vulkan against the CPU reference</h2><div class=\"tabs\">{}</div>{}</section>\n",
                       tabs, sliders);
}

std::string heatsHtml(const std::vector<HeatPicture>& heats) {
    std::string html = "<section><h2>Where they differ</h2><div class=\"heats\">";
    for (const HeatPicture& heat : heats)
        html += fmt::format("<div><img alt=\"{0}\" src=\"{1}\"><p>{0}</p><p class=\"soft\">{2}</p></div>",
                            escapeHtml(heat.name), pngDataUri(heat.png), escapeHtml(heat.about));
    return html + "</div></section>\n";
}

std::string worstHtml(double worst) {
    if (worst <= 0) return "equal";
    return fmt::format("{0:.1f} %<span class=\"meter\"><i style=\"width:{0:.1f}%\"></i></span>",
                       std::min(100.0, 100 * worst));
}

std::string quantitiesHtml(const Findings& f) {
    std::string rows =
        "<tr><th>quantity</th><th class=\"number\">compared</th><th class=\"number\">excused</th><th "
        "class=\"number\">worst, of its tolerance</th></tr>";
    for (const Quantity& q : f.quantities())
        rows += fmt::format(
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
            "class=\"number\">{}</td></tr>",
            escapeHtml(q.name), groupedDigits(q.compared), groupedDigits(q.excused), worstHtml(q.worst));
    for (const Figure& figure : f.figures())
        rows += fmt::format("<tr><td>{}</td><td class=\"number\" colspan=\"3\">{}</td></tr>", escapeHtml(figure.name),
                            escapeHtml(figure.text));
    return "<table>" + rows + "</table>";
}

std::string checkHtml(const CheckResult& row) {
    const Findings& f = row.findings;
    const char* kind = !row.agrees() ? "bad" : (f.refusal().empty() ? "good" : "soft");
    const char* outcome = !row.agrees() ? "disagrees" : (f.refusal().empty() ? "agrees" : "refused");
    return fmt::format(
        "<tr><td><details><summary>{}</summary>{}</details></td><td class=\"soft\">{}{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{:.2f} s</td><td "
        "class=\"{}\">{}</td></tr>\n",
        escapeHtml(row.check->name), quantitiesHtml(f), escapeHtml(row.check->about),
        f.refusal().empty() ? "" : ". Refused: " + escapeHtml(f.refusal()), groupedDigits(f.compared()),
        worstHtml(f.worst()), row.seconds, kind, outcome);
}

std::string ladderHtml(const LadderResult& ladder) {
    std::string rows;
    for (std::size_t rung = 0; rung < kRungs.size(); ++rung) {
        rows += fmt::format("<tr class=\"rung\"><td colspan=\"6\">{} {} <span>{}</span></td></tr>", rung + 1,
                            kRungs[rung].name, escapeHtml(kRungs[rung].about));
        bool any = false;
        for (const CheckResult& row : ladder.checks) {
            if (static_cast<std::size_t>(row.check->rung) != rung) continue;
            rows += checkHtml(row);
            any = true;
        }
        if (!any) rows += "<tr><td colspan=\"6\" class=\"soft\">not climbed: a rung below disagrees</td></tr>";
    }
    return "<section><h2>The ladder</h2><div class=\"scroll\"><table><tr><th>check</th><th>what is compared</th><th "
           "class=\"number\">compared</th><th class=\"number\">worst, of its tolerance</th><th "
           "class=\"number\">time</th><th>result</th></tr>" +
           rows + "</table></div></section>\n";
}

std::string settingsHtml(const Json& settings) {
    std::string rows;
    for (const auto& [name, value] : settings.items())
        rows += fmt::format("<tr><td>{}</td><td>{}</td></tr>", escapeHtml(name),
                            escapeHtml(value.is_string() ? value.get<std::string>() : value.dump()));
    return "<section><h2>Settings</h2><table class=\"settings\">" + rows + "</table></section>\n";
}

}  // namespace

std::string reportHtml(const ReportPage& page) {
    const std::string title = escapeHtml(page.title);
    return fmt::format(
               "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
               "content=\"width=device-width,initial-scale=1\"><title>vkpt verify: {}</title><style>{}</style>"
               "</head>\n<body><main><h1>{}</h1><p class=\"soft\">vkpt verify: {} against the CPU reference</p>\n",
               title, kStyle, title, escapeHtml(page.device)) +
           verdictHtml(page.ladder) + slidersHtml(page.pairs) + heatsHtml(page.heats) + ladderHtml(page.ladder) +
           settingsHtml(page.settings) + fmt::format("</main><script>{}</script></body></html>\n", kScript);
}

}  // namespace vkpt
