#include "control/images/film_plan.h"

#include "base/number_text.h"
#include "settings/setting_options.h"
#include "shell_word.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gluray::launcher {
namespace {

constexpr size_t kDigits = 4, kMaxDigits = 9;

bool readRampEnd(std::string_view text, double& number) {
  return readNumber(text, number) && std::isfinite(number);
}

}  // namespace

std::string FilmName::file(int number) const {
  const std::string text = std::to_string(number);
  return before + std::string(digits - std::min(digits, text.size()), '0') + text + after;
}

std::string FilmName::pattern() const {
  return before + (digits > 1 ? "%0" + std::to_string(digits) + "d" : "%d") + after;
}

std::string readFilmName(const std::string& text, FilmName& name, const std::string& ending) {
  if (!text.ends_with(ending) || text.size() == ending.size() || text.ends_with("/" + ending))
    return text + ": use a name that ends in " + ending + ", such as film-%04d" + ending;
  const size_t sign = text.find('%');
  if (sign == text.npos) {
    name = {text.substr(0, text.size() - ending.size()), ending, kDigits};
    if (!name.before.ends_with('-') && !name.before.ends_with('_')) name.before += '-';
    return "";
  }
  const size_t letter = text.find_first_not_of("0123456789", sign + 1);
  const std::string width = text.substr(sign + 1, letter - sign - 1);
  const bool padded = width.size() >= 2 && width[0] == '0';
  size_t digits = 1;
  if (padded) std::from_chars(width.data(), width.data() + width.size(), digits);
  if (text[letter] != 'd' || (!width.empty() && !padded) || digits < 1 || digits > kMaxDigits ||
      text.find('%', letter) != text.npos)
    return text + ": use one %d or %04d for the number, and no other % in the name";
  name = {text.substr(0, sign), text.substr(letter + 1), digits};
  return "";
}

nlohmann::json Ramp::value(int image, int of) const {
  const double share = of > 1 ? (image - 1.0) / (of - 1.0) : 0;
  const double value = image == of && of > 1 ? to : from + (to - from) * share;
  return whole ? nlohmann::json(static_cast<int64_t>(std::llround(value))) : nlohmann::json(value);
}

std::string readRamp(const std::string& text, Ramp& ramp) {
  const size_t sign = text.find('='), dots = text.find("..", sign);
  if (sign == text.npos || dots == text.npos)
    return text + ": use NAME=FROM..TO, such as lights.azimuth=0..90";
  ramp.name = text.substr(0, sign);
  const Row* row = findSetting(ramp.name);
  if (!row) return unknownSetting(ramp.name);
  ramp.whole = row->type == Type::integer;
  if (!ramp.whole && row->type != Type::real)
    return ramp.name + ": only settings that are one number can vary";
  const std::string from = text.substr(sign + 1, dots - sign - 1), to = text.substr(dots + 2);
  for (const std::string& end : {from, to})
    if (std::string why = problemOfPair(ramp.name + "=" + end); !why.empty()) return why;
  const bool read = readRampEnd(from, ramp.from) && readRampEnd(to, ramp.to);
  return read ? "" : text + ": use numbers for FROM and TO";
}

std::string filmCommand(const FilmName& name, int images, bool more, bool odd) {
  std::string film = name.before;
  while (film.ends_with('-') || film.ends_with('_')) film.pop_back();
  if (film.empty() || film.ends_with('/')) film += "film";
  std::string command = "ffmpeg -framerate 25 -i " + shellWord(name.pattern());
  if (more) command += " -frames:v " + std::to_string(images);
  if (odd) command += " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2'";  // what players take has even sides
  return command + " -pix_fmt yuv420p " + shellWord(film + ".mp4");
}

}  // namespace gluray::launcher
