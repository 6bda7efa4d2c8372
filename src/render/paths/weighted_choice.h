// A choice by weights. Any thread.
#pragma once
#include <cmath>

namespace gluray::render {

/// Chooses by weights, one after the other, with a single random number (weighted reservoir of one).
struct WeightedChoice {
  float rest;                  // the random number, in [0, 1)
  float total = 0, share = 0;  // sum of the weights; the chosen one's
  /// Whether the one of this weight is chosen so far.
  bool takes(float weight) {
    if (!(weight > 0) || !std::isfinite(weight)) return false;
    total += weight;
    const float keep = weight / total;
    if (rest < keep) {
      share = weight, rest /= keep;
      return true;
    }
    rest = (rest - keep) / (1 - keep);
    return false;
  }
};

}  // namespace gluray::render
