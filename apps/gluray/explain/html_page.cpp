#include "explain/html_page.h"

#include "base/printable.h"
#include "control/messages/base64.h"
#include "text_table.h"

namespace gluray::launcher {
namespace {

constexpr int kAmplified = 8;

const char* const kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>gluray explain</title>
<style>
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 1320px; padding: 0 1em; color: #222; background: #fafafa }
h1 { font-size: 1.3em } code, pre { font: 13px/1.35 ui-monospace, monospace } pre { overflow-x: auto; background: #fff; border: 1px solid #ddd; padding: 1em }
.images { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 1em }
figure { margin: 0 } figcaption { margin: .3em 0 } img { max-width: 100%; height: auto; image-rendering: pixelated; border: 1px solid #ccc }
.warning { border-left: 4px solid #d60; padding: .2em 1em; background: #fff }
.key { display: inline-block; width: .9em; height: .9em; margin: 0 .2em 0 .6em }
</style></head><body>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string figure(const std::string& id, const Pixels& pixels, const std::string& caption) {
  return "<figure><img id=\"" + id + "\" alt=\"" + id + "\" width=\"" + std::to_string(pixels.width) +
         "\" src=\"data:image/png;base64," + control::toBase64(pngOf(pixels)) + "\"><figcaption>" + caption +
         "</figcaption></figure>\n";
}

std::string percent(uint64_t part, uint64_t all) {
  return all ? fixed(100.0 * static_cast<double>(part) / static_cast<double>(all), 3) + " %" : "none";
}

std::string warning(const std::string& text) { return "<p class=\"warning\">" + text + "</p>\n"; }

/// How the two images were taken, and whether they show the same frame.
std::string provenance(const FrameImages& p, const Comparison& c) {
  std::string text =
      "<p>Both images are read from the program's window just before it shows them. The program ran twice, "
      "the second time with the real OpenGL alone; its clock moved by 40 ms a frame in both runs. ";
  if (p.atRest)
    text += "The program came to rest: these are the last frames, number " + std::to_string(p.frame) +
            " with GLuRay and " + std::to_string(p.frameWithout) + " without.</p>\n";
  else
    text += "Both images are of frame " + std::to_string(p.frame) + ".</p>\n";
  if (!c.sameSize) return text + warning("The images differ in size: the window changed between the runs.");
  if (!c.sameFrame())
    text += warning(
        "<b>The two runs did not show the same frame:</b> " + percent(c.outsideDiffering, c.outside) +
        " of the pixels that the real OpenGL drew in both runs differ, so the program draws something else "
        "in each run. The difference below includes that.");
  else
    text += "<p>Of the " + grouped(c.outside) + " pixels that the real OpenGL drew in both runs " +
            (c.outsideDiffering
                 ? percent(c.outsideDiffering, c.outside) + " differ, too few for a different frame"
                 : "none differs: both seem to be the same frame") +
            ".</p>\n";
  return text;
}

std::string numbers(const Comparison& c) {
  return "<p><b>" + percent(c.differing, c.pixels) + "</b> of the " + grouped(c.pixels) +
         " pixels differ by more than " + std::to_string(Comparison::kTolerance) + " of 255 (" +
         percent(c.differingAtAll, c.pixels) + " differ at all; the largest difference is " +
         std::to_string(c.largest) + "). <b>" + percent(c.traced, c.pixels) + "</b> were traced, " +
         percent(c.drawnOver, c.pixels) + " were traced and drawn over by the real OpenGL afterwards.</p>\n";
}

const char* const kPerPixel =
    "<p>Lighting was evaluated at each pixel. OpenGL evaluates it at the vertices only, so highlights on "
    "coarse meshes differ. With <code>--shading vertex</code> GLuRay does as OpenGL does.</p>\n";

uint64_t countOf(const Pixels& origin, Origin wanted) {
  uint64_t count = 0;
  for (const uint8_t byte : origin.bytes) count += static_cast<Origin>(byte) == wanted;
  return count;
}

}  // namespace

nlohmann::json imageFacts(const FrameImages& p) {
  nlohmann::json facts = {{"frame", p.frame},
                          {"width", p.with.width},
                          {"height", p.with.height},
                          {"traced", countOf(p.origin, Origin::traced)},
                          {"drawnOver", countOf(p.origin, Origin::drawnOver)},
                          {"tracedElsewhere", p.elsewhere},
                          {"atRest", p.atRest}};
  if (!p.without) return facts;
  const Comparison c = compare(p.with, *p.without, p.origin);
  facts["frameWithout"] = p.frameWithout;
  facts["sameSize"] = c.sameSize;
  if (!c.sameSize) return facts;
  facts.update({{"pixels", c.pixels},
                {"differing", c.differing},
                {"differingAtAll", c.differingAtAll},
                {"largest", c.largest},
                {"outside", c.outside},
                {"outsideDiffering", c.outsideDiffering},
                {"sameFrame", c.sameFrame()}});
  return facts;
}

std::string htmlPage(const std::string& command, const std::string& text, const FrameImages& p) {
  std::string page =
      std::string(kHead) + "<h1>gluray explain <code>" + escaped(printable(command)) + "</code></h1>\n";
  const Comparison c = p.without ? compare(p.with, *p.without, p.origin) : Comparison{};
  if (!p.without)
    page += warning("There is no image without GLuRay: the second run of the program showed none.");
  else
    page += provenance(p, c) + (c.sameSize ? numbers(c) : "") + (p.perPixel ? kPerPixel : "");
  if (p.elsewhere)
    page += "<p>" + grouped(p.elsewhere) +
            " pixels were traced into framebuffer objects during the frame; they do not count as traced "
            "here, even if the program copies them into its window.</p>\n";
  page += "<div class=\"images\">\n" + figure("with", p.with, "with GLuRay");
  if (p.without) page += figure("without", *p.without, "without: the real OpenGL alone");
  if (c.sameSize)
    page += figure("difference", difference(p.with, *p.without, kAmplified),
                   "the difference, " + std::to_string(kAmplified) + " times as bright");
  page += figure("traced", tinted(p.with, p.origin),
                 "who drew each pixel:<span class=\"key\" style=\"background:#2b2\"></span>traced"
                 "<span class=\"key\" style=\"background:#e80\"></span>traced, then drawn over"
                 "<span class=\"key\" style=\"background:#555\"></span>rasterised by the real OpenGL");
  page += "</div>\n<h1>What was drawn</h1>\n<pre>" + escaped(text) + "</pre>\n";
  return page + "<script type=\"application/json\" id=\"facts\">" + imageFacts(p).dump() +
         "</script>\n</body></html>\n";
}

}  // namespace gluray::launcher
