// FamilyReader: impostors, and passes that GLuRay makes itself.
#include "gl/families/files/family_reader.h"

namespace gluray::gl {

void FamilyReader::readShape() {
  using scene::Shape;
  using Billboards = scene::Impostors::Billboards;
  FamilyImpostors& f = family_.impostors;
  choice("shape",
         {{"spheres", Shape::spheres},
          {"discs", Shape::discs},
          {"cylinders", Shape::cylinders},
          {"beads", Shape::beads},
          {"tubes", Shape::tubes},
          {"splats", Shape::splats},
          {"sticks", Shape::sticks}},
         f.shape);
  if (!f.given()) fail(here(), "impostors need a shape");
  const char* const billboards = has("cards") ? "cards" : "billboards";  // cards: the older word
  choice(billboards,
         {{"silhouette", Billboards::silhouette},
          {"triangle", Billboards::triangle},
          {"faces", Billboards::faces},
          {"sent", Billboards::square}},
         f.billboards);
  f.sent = f.billboards == Billboards::square;
  if ((f.billboards == Billboards::faces) && f.shape != Shape::cylinders)
    fail(at(billboards), "billboards = \"faces\" is for cylinders only");
  if (f.billboards == Billboards::triangle && f.shape == Shape::cylinders)
    fail(at(billboards), "billboards = \"triangle\" is not for cylinders");
}

void FamilyReader::readImpostors() {
  readShape();
  FamilyImpostors& f = family_.impostors;
  value("radius", f.radius);
  name("axis", f.axis);
  value("inside", f.inside);
  value("radius_divisor", f.radiusDivisor);
  flag("fades", f.fades);
  flag("gaussian", f.gaussian);
  flag("antialiased", f.antialiased);
  value("outline", f.outline);
  flag("instances", f.instances);
  flag("grows", f.grows);
  flag("in_pixels", f.inPixels);
  value("longer", f.longer);
  name("viewport", f.viewport);
  value("size", f.size);
  value("bulge", f.bulge);
  value("bulge_depth", f.bulgeDepth);
  value("depth_bias", f.depthBias);
  value("scale", f.scale);
  value("lowpass", f.lowpass);
  value(has("card_scale") ? "card_scale" : "billboard_scale", f.billboardScale);
  name("projection", f.projection);
  readSentBillboards();
  const bool pixels = scene::isSizedInPixels(f.shape);
  if (pixels && !(f.bulge.given() && f.bulgeDepth.given()))
    fail(here(), "beads and tubes need bulge and bulge_depth");
  const bool tubes = f.shape == scene::Shape::tubes;
  if (f.size.given() ? !pixels : tubes) fail(here(), "tubes need size, and only beads and tubes have one");
  if (f.inPixels ? !tubes || f.viewport.empty() : f.longer.given() || !f.viewport.empty())
    fail(here(), "in_pixels is for tubes and needs viewport; longer and viewport need in_pixels");
}

void FamilyReader::readSentBillboards() {
  FamilyImpostors& f = family_.impostors;
  name("corners", f.corners);
  choice("viewer", {{"origin", false}, {"infinite", true}}, f.parallelView);
  flag("radius_in_position", f.radiusInPosition);
  flag("radius_in_corners", f.radiusInCorners);
  flag("hemispheres", f.hemispheres);
  flag("radius_in_object_space", f.radiusInObject);
  flag("zero_scale_is_one", f.zeroScaleIsOne);
  name("end", f.end);
  name("end_color", f.endColor);
  name("caps", f.caps);
  name("round_caps", f.roundCaps);
  eachValue("halves_blend", f.halvesBlend);
}

void FamilyReader::readPass() {
  choice("does",
         {{"fxaa", Family::Pass::fxaa},
          {"peel_depths", Family::Pass::peelDepths},
          {"peel", Family::Pass::peel},
          {"peel_rest", Family::Pass::peelRest},
          {"sum", Family::Pass::sum},
          {"resolve", Family::Pass::resolve}},
         family_.pass);
  name("input", family_.passInput);
  text("output", family_.passOutput);
  name("texel", family_.passTexel);
  value("samples", family_.passSamples);
  value("gamma", family_.passGamma);
  value("relative_contrast", family_.relativeContrast);
  value("hard_contrast", family_.hardContrast);
  value("subpixel_blend_limit", family_.subpixelBlendLimit);
  value("subpixel_contrast", family_.subpixelContrast);
  value("endpoint_search_iterations", family_.endpointSearchIterations);
}

}  // namespace gluray::gl
