// What the library sees of the types of its interface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <plumbline/types.hpp>

#include "base/diagnostic.hpp"
#include "base/files/destination.hpp"
#include "base/files/source.hpp"
#include "machine/model.hpp"

namespace plumbline::api {
inline namespace v1 {

struct Model::Impl {
  Source source;  // its text
  machine::MachineModel machine;
};

struct Result::Impl {
  std::string json, words;
  std::vector<Diagnostic> warnings;
  bool found = false;
  std::string model;
  std::optional<Error> no_model;  // why there is none
};

struct Inside {
  using Found = Result::Impl;

  static Source source(const Input& input);
  /// Of no output: nobody, who takes the bytes.
  static Destination destination(const Output& output);
  static bool is_nothing(const Output& output) { return output.name_.empty() && !output.take_; }
  /// Throws wrong_usage if there is none.
  static const Model::Impl& machine_of(const Model& model);
  /// Empty if there is none.
  static Source source(const Model& model) { return model.impl_ ? model.impl_->source : Source(); }
  static Result result(Found found);
};

Diagnostic public_diagnostic(const plumbline::Diagnostic& diagnostic);
/// The other way.
plumbline::Diagnostic inner_diagnostic(const Diagnostic& diagnostic);

/// Throws the Error that says what is wrong with a call.
[[noreturn]] void wrong_usage(std::string message, std::string help = "");
[[noreturn]] void no_model();

}  // namespace v1
}  // namespace plumbline::api
