// What is expected to be left at the tip: words, JSON, columns of tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "jobs/expected/expected_error.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {

/// Rows of a summary: as the tip stands, with the zero touched off, each by what makes it; and from what it is known.
void add_expected(TextTable& table, const jobs::ExpectedError& expected);
/// The same as lines of their own; empty: nothing is known.
std::string expected_text(const std::optional<jobs::ExpectedError>& expected);

/// null: nothing is known.
nlohmann::ordered_json expected_json(const std::optional<jobs::ExpectedError>& expected);

/// Names of columns, each after a comma: what is expected and what 95 % are within, um; then by what makes it.
std::string_view expected_columns();
/// The numbers; NaN where nothing is known.
std::vector<double> expected_numbers(const std::optional<jobs::PoseDoubt>& doubt);
/// The numbers; empty columns where nothing is known.
void append_expected(std::string& row, const std::optional<jobs::PoseDoubt>& doubt);

}  // namespace plumbline::report
