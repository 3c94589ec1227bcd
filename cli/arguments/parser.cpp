#include "cli/arguments/parser.hpp"

#include <CLI/App.hpp>
#include <CLI/Error.hpp>
#include <memory>

#include "cli/arguments/help_formatter.hpp"

namespace wend::cli {

Argument Argument::required() const {
  option_->required();
  return *this;
}

Argument Argument::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

Argument Argument::group(const std::string& name) const {
  option_->group(name);
  return *this;
}

Argument Argument::excludes(const Argument& other) const {
  option_->excludes(other.option_);
  return *this;
}

Argument Argument::former_name_of(const Argument& current) const {
  option_->excludes(current.option_)->group("");
  return *this;
}

Argument Argument::optional_value() const {
  option_->expected(0, 0);  // and not expected(0), which is a flag that is "true"
  return *this;
}

Argument Argument::one_at_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}

Argument Argument::separated_by_commas() const {
  option_->delimiter(',')->allow_extra_args(false);
  return *this;
}

Parser Parser::add_subcommand(const std::string& name, const std::string& description) {
  return Parser(*app_->add_subcommand(name, description));
}

void Parser::require_subcommand() { app_->require_subcommand(1); }

void Parser::leave_all_words() {
  app_->set_help_flag();
  app_->set_help_all_flag();
  app_->prefix_command();
}

Argument Parser::add_option(const std::string& flags, std::string& value, const std::string& help) {
  return Argument(*app_->add_option(flags, value, help));
}

Argument Parser::add_option(const std::string& flags, std::vector<std::string>& values,
                            const std::string& help) {
  return Argument(*app_->add_option(flags, values, help));
}

Argument Parser::add_option(const std::string& flags, const AssignText& assign,
                            const std::string& help) {
  return Argument(*app_->add_option_function<std::string>(flags, assign, help));
}

Argument Parser::add_list(const std::string& flags, const AssignTexts& assign,
                          const std::string& help) {
  return Argument(*app_->add_option_function<std::vector<std::string>>(flags, assign, help));
}

Argument Parser::add_flag(const std::string& flags, bool& value, const std::string& help) {
  return Argument(*app_->add_flag(flags, value, help));
}

Argument Parser::add_flag(const std::string& flags, const AssignCount& assign,
                          const std::string& help) {
  return Argument(*app_->add_flag_function(flags, assign, help));
}

void Parser::further(const std::vector<std::string>& flags) {
  for (const std::string& flag : flags) {
    if (CLI::Option* option = app_->get_option_no_throw(flag)) option->group(kFurtherGroup);
  }
}

void Parser::add_choice_help(const std::string& flag, const ChoiceHelp& help) {
  // All apps share the formatter of the program.
  const auto formatter = std::dynamic_pointer_cast<HelpFormatter>(app_->get_formatter());
  if (formatter) formatter->add_choice_help(*app_, flag, help);
}

void Parser::footer(const std::string& text) { app_->footer(text); }

void Parser::hide() { app_->group(""); }

bool Parser::parsed() const { return app_->parsed(); }

std::string Parser::typed(const std::string& flag) const {
  const CLI::Option* option = app_->get_option_no_throw(flag);
  if (option == nullptr) return {};
  if (option->count() > 0) return flag;
  for (const CLI::Option* former : option->get_excludes()) {
    if (former->get_group().empty() && former->count() > 0)
      return "--" + former->get_lnames().front();
  }
  return {};
}

std::vector<const CLI::App*> visible_subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); });
}

void refuse_value(const std::string& flags, const std::string& what) {
  throw CLI::ValidationError(flags, what);
}

}  // namespace wend::cli
