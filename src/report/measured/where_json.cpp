#include "report/measured/where_json.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"

namespace plumbline::report {
namespace {

using Json = nlohmann::ordered_json;

template <class Numbers>
Json scaled_list(const Numbers& values, double unit) {
  Json json = Json::array();
  for (const double value : values) json.push_back(rounded(value / unit));
  return json;
}

Json two_json(const diagnose::BarAndTorque& rms) {
  return {{"radial_um", rounded(rms.radial / kUm)}, {"torque_Nm", rounded(rms.torque)}};
}

Json channel_json(const diagnose::ChannelResiduals& channel) {
  const bool radial = channel.channel == identify::kRadial;
  const double unit = radial ? kUm : 1;
  return {{"channel", std::string(identify::channel_name(channel.channel)) + (radial ? "_um" : "_Nm")},
          {"rms", rounded(channel.rms / unit)},
          {"arcs_rms", scaled_list(channel.arcs, unit)},
          {"harmonics_rms", scaled_list(channel.waves, unit)},
          {"harmonics_noise", scaled_list(channel.wave_noise, unit)}};
}

Json reversal_json(const diagnose::Reversal& reversal) {
  const auto figure = [](double value, double error, double unit) {
    return error > 0 ? rounded(value / unit) : Json();
  };
  return {{"strut", reversal.strut + 1},
          {"count", reversal.count},
          {"length_um", figure(reversal.length, reversal.length_error, kUm)},
          {"length_standard_error_um", figure(reversal.length_error, reversal.length_error, kUm)},
          {"torque_Nm", figure(reversal.torque, reversal.torque_error, 1)},
          {"torque_standard_error_Nm", figure(reversal.torque_error, reversal.torque_error, 1)}};
}

}  // namespace

Json rounded(double value) {
  constexpr int kDigits = 6;
  const std::optional<double> number = parse_number(fmt::format("{:.{}g}", value, kDigits));
  return number ? Json(*number) : Json(nullptr);
}

Json where_json(const diagnose::GapMap& map) {
  Json json{{"channels", Json::array()},
            {"contrasts", Json::array()},
            {"groups", Json::array()},
            {"reversals", Json::array()}};
  for (const diagnose::ChannelResiduals& channel : map.channels) json["channels"].push_back(channel_json(channel));
  for (const diagnose::Contrast& c : map.contrasts) {
    json["contrasts"].push_back(
        {{"by", to_text(c.by)},
         {"pairs", c.pairs},
         {"common_rms", two_json(c.common)},
         {"differs_rms", two_json(c.differs)},
         {"correlation", {{"radial", rounded(c.radial.correlation)}, {"torque", rounded(c.torque.correlation)}}}});
  }
  for (const diagnose::RunGroup& group : map.groups) {
    json["groups"].push_back({{"by", to_text(group.by)},
                              {"from", rounded(group.from)},
                              {"to", rounded(group.to)},
                              {"runs", group.runs},
                              {"rms", two_json(group.rms)}});
  }
  for (const diagnose::Reversal& reversal : map.reversals) json["reversals"].push_back(reversal_json(reversal));
  return json;
}

CircularityOfRuns circularity_of(const std::vector<diagnose::RunGap>& runs) {
  CircularityOfRuns all;
  diagnose::Circularity& sum = all.mean;
  diagnose::Circularity& most = all.largest;
  for (const diagnose::RunGap& run : runs) {
    if (!run.circularity) continue;
    const diagnose::Circularity& of = *run.circularity;
    ++all.runs;
    sum = {sum.measured + of.measured, sum.given + of.given, sum.found + of.found};
    most = {std::max(most.measured, of.measured), std::max(most.given, of.given), std::max(most.found, of.found)};
  }
  const double count = std::max(all.runs, 1);
  sum = {sum.measured / count, sum.given / count, sum.found / count};
  return all;
}

Json circularity_json(const CircularityOfRuns& circularity) {
  if (circularity.runs == 0) return nullptr;
  const auto pair = [](double mean, double largest) {
    return Json{{"mean", rounded(mean / kUm)}, {"largest", rounded(largest / kUm)}};
  };
  const diagnose::Circularity& mean = circularity.mean;
  const diagnose::Circularity& most = circularity.largest;
  return {{"measured", pair(mean.measured, most.measured)},
          {"compensated_with_given", pair(mean.given, most.given)},
          {"compensated_with_found", pair(mean.found, most.found)}};
}

}  // namespace plumbline::report
