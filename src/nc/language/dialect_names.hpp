// What the tables of grammar/ call things. Each refuses an unknown name with InternalError.
#pragma once

#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

Action action_named(std::string_view name);
Statements statements_named(std::string_view name);
Labels labels_named(std::string_view name);
SystemVariables system_variables_named(std::string_view name);
GuardLanguage guard_named(std::string_view name);
FlowWord keyword_named(std::string_view name);
Operation operation_named(std::string_view name);
FeedRule feed_rule_named(std::string_view name);

}  // namespace plumbline::nc
