#include "settings/setting_options.h"

#include "settings/values.h"
#include "text_table.h"

namespace gluray::launcher {
namespace {

constexpr size_t kWidth = 92;

/// The setting's help, a line for each word of a choice, and the default.
std::string helpOf(const Row& row) {
  std::string text(row.help);
  if (text.ends_with('.')) text.pop_back();
  const bool shown = row.type != Type::boolean && row.type != Type::quirks && row.type != Type::list;
  const std::string initial = printValue(row, Session{});
  if (shown && !initial.empty()) text.append(" [").append(initial).append("]");
  text = wrapped(text, kWidth, "");
  for (const Word& word : row.words)
    if (!word.help.empty())
      text += wrapped(std::string(word.word) + ": " + std::string(word.help), kWidth, "");
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

/// Why the value is invalid for the setting; empty: it is valid.
std::string problemOf(const Row& row, const std::string& value) {
  Session session;
  std::string why = readValue(row, value, session);
  if (!why.empty()) return row.type == Type::quirks ? why : value + ": " + why;
  if (!row.exists) return "";
  const Place place = row.place(session);
  const auto* list = std::get_if<std::vector<std::string>*>(&place);
  for (std::string file : list ? **list : std::vector<std::string>{value})
    if (why = file.empty() ? "" : CLI::ExistingFile(file); !why.empty()) return why;
  return "";
}

void addOption(CLI::App& app, ChosenSettings& chosen, const Row& row) {
  const std::string option(row.option);
  const auto add = [&chosen, &row](const std::string& value) { chosen.add(row.name, value); };
  if (row.type == Type::boolean) {
    app.add_flag_callback(
           option, [add] { add("1"); }, helpOf(row))
        ->trigger_on_parse();
    return;
  }
  app.add_option_function<std::string>(option, add, helpOf(row))
      ->check([&row](const std::string& value) { return problemOf(row, value); })
      ->type_name(std::string(row.placeholder))
      ->trigger_on_parse();
}

}  // namespace

std::string problemOfPair(const std::string& pair) {
  const size_t sign = pair.find('=');
  if (sign == pair.npos) return pair + ": use NAME=VALUE";
  const Row* row = findSetting(pair.substr(0, sign));
  if (!row) return unknownSetting(pair.substr(0, sign));
  const std::string why = problemOf(*row, pair.substr(sign + 1));
  return why.empty() ? "" : std::string(row->name) + " = " + why;
}

void addSettingOptions(CLI::App& app, ChosenSettings& chosen, bool explain) {
  for (const Row& row : settingRows())
    if (!row.option.empty() && (row.explains || !explain)) addOption(app, chosen, row);
  const auto add = [&chosen](const std::string& pair) {
    const size_t sign = pair.find('=');
    chosen.add(pair.substr(0, sign), pair.substr(sign + 1));
  };
  app.add_option_function<std::string>("--set", add, "Give any setting a value; gluray settings lists them")
      ->check(problemOfPair)
      ->type_name("NAME=VALUE")
      ->trigger_on_parse();
}

}  // namespace gluray::launcher
