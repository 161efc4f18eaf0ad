#include <cmath>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <plumbline/types.hpp>

#include "api/guarded.hpp"
#include "api/inside.hpp"
#include "base/files/input_file.hpp"
#include "base/text/hash.hpp"
#include "machine/model_file.hpp"

namespace plumbline::api {
inline namespace v1 {

Output Output::stream(std::ostream& into) {
  return Output("<stream>", [&into](std::string_view bytes) {
    if (into.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return;
    throw Error(Error::Kind::refused,
                {"file-unwritable", "cannot be written: the stream has failed", "look at the stream", {"<stream>"}});
  });
}

Model::Model(const Input& input)
    : impl_(guarded([&] {
        const plumbline::Source given = Inside::source(input);
        Source held = given.is_held() ? given : Source::held(given.name(), read_text(given));
        machine::MachineModel machine = machine::read_model(held);
        return std::make_shared<const Impl>(Impl{std::move(held), std::move(machine)});
      })) {}

std::string Model::name() const { return impl_ ? impl_->machine.name : ""; }
std::string Model::hash() const { return impl_ ? to_hex(impl_->machine.hash) : ""; }
std::string Model::file() const { return impl_ ? impl_->source.name() : ""; }
std::string Model::text() const { return impl_ ? *impl_->source.text() : ""; }

const std::string& Result::json() const { return impl_->json; }
const std::string& Result::words() const { return impl_->words; }
const std::vector<Diagnostic>& Result::warnings() const { return impl_->warnings; }
bool Result::found() const { return impl_->found; }

double Result::number(std::string_view path) const {
  using Json = nlohmann::json;
  const Json whole = Json::parse(impl_->json);
  const Json* at = &whole;
  for (std::size_t begin = 0; begin <= path.size() && at != nullptr;) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string key(path.substr(begin, end - begin));
    const bool is_index = at->is_array() && !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
    if (at->is_object() && at->contains(key)) {
      at = &(*at)[key];
    } else if (is_index && key.size() < 10 && std::stoul(key) < at->size()) {
      at = &(*at)[std::stoul(key)];
    } else {
      at = nullptr;
    }
    begin = end + 1;
  }
  if (at != nullptr && at->is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (at == nullptr || !at->is_number()) wrong_usage(fmt::format("the result has no number {}", path));
  return at->get<double>();
}

const std::string& Result::model() const {
  if (impl_->no_model) throw *impl_->no_model;
  return impl_->model;
}

Source Inside::source(const Input& input) {
  return input.text_ ? Source::held(input.name_, input.text_) : Source(input.name_);
}

Destination Inside::destination(const Output& output) {
  if (is_nothing(output)) return Destination::taken("<nothing>", [](std::string_view) {});
  return output.take_ ? Destination::taken(output.name_, output.take_) : Destination(output.name_);
}

const Model::Impl& Inside::machine_of(const Model& model) {
  if (!model.impl_) no_model();
  return *model.impl_;
}

Result Inside::result(Found found) {
  Result result;
  result.impl_ = std::make_shared<const Found>(std::move(found));
  return result;
}

}  // namespace v1
}  // namespace plumbline::api
