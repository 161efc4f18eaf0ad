#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "base/check.hpp"
#include "report/diagnostic_json.hpp"

namespace plumbline::api {

void throw_on() {
  try {
    throw;
  } catch (const Refusal& refusal) {
    throw Error(Error::Kind::refused, public_diagnostic(refusal.diagnostic()));
  } catch (const InternalError& bug) {
    throw Error(Error::Kind::bug,
                {"internal-error", bug.what(), "please report it with the call, the program and the model", {}});
  }
}

inline namespace v1 {

Error::Error(Kind kind, Diagnostic diagnostic)
    : kind_(kind), diagnostic_(std::move(diagnostic)), what_(to_text(inner_diagnostic(diagnostic_))) {
  while (what_.ends_with('\n')) what_.pop_back();
}

Error::~Error() = default;

const char* Error::what() const noexcept { return what_.c_str(); }

std::string Error::json() const { return report::diagnostic_json(inner_diagnostic(diagnostic_)); }

Diagnostic public_diagnostic(const plumbline::Diagnostic& d) {
  const plumbline::Place& place = d.place;
  return {d.code,
          d.message,
          d.help,
          {place.file, place.line, place.column, place.length, place.text},
          static_cast<Severity>(d.severity)};
}

plumbline::Diagnostic inner_diagnostic(const Diagnostic& d) {
  const Place& place = d.place;
  return {d.code,
          d.message,
          d.help,
          {place.file, place.line, place.column, place.length, place.text},
          static_cast<plumbline::Severity>(d.severity)};
}

void wrong_usage(std::string message, std::string help) {
  throw Error(Error::Kind::wrong_usage, {"usage-wrong", std::move(message), std::move(help), {}});
}

void no_model() {
  wrong_usage("a model of the machine is needed",
              "give one; or, with options, settings and a machine that they describe");
}

}  // namespace v1
}  // namespace plumbline::api
