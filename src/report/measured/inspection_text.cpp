#include "report/measured/inspection_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "identify/equations/run_model.hpp"

namespace plumbline::report {
namespace {

using inspect::Fault;
using inspect::FaultKind;
using measure::Run;

std::string place_text(const std::vector<double>& values, double unit, int decimals) {
  std::vector<std::string> each;
  for (const double value : values) each.push_back(fmt::format("{:.{}f}", value / unit + 0.0, decimals));
  return fmt::format("{}", fmt::join(each, ", "));
}

std::string tilt_text(const Run& run) { return place_text({run.tilt.x(), run.tilt.y(), run.tilt.z()}, kDeg, 1); }

std::string centre_text(const Run& run) {
  return place_text({run.centre_W.x(), run.centre_W.y(), run.centre_W.z()}, kMm, 1);
}

std::string channel_text(const std::vector<int>& channels) {
  if (channels.size() == 6) return "the torques";
  std::vector<std::string> names;
  for (const int channel : channels) {
    names.push_back(channel == identify::kRadial ? "the bar" : fmt::format("motor {}", channel));
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

// Three and more that follow each other as "A to B".
std::string runs_text(const std::vector<std::size_t>& numbers, const std::vector<Run>& runs) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last < i + 2) last = i;
    each.push_back(last == i ? runs[numbers[i]].id
                             : fmt::format("{} to {}", runs[numbers[i]].id, runs[numbers[last]].id));
    i = last + 1;
  }
  return fmt::format("{}", fmt::join(each, ", "));
}

// What would mend it: "with direction cw instead of ccw".
std::string label_text(const Fault& fault, const Run& run, const std::vector<Run>& runs) {
  const double value = fault.values.empty() ? 0 : fault.values[0];
  switch (fault.kind) {
    case FaultKind::direction:
      return fmt::format("with direction {} instead of {}", run.turn() > 0 ? "cw" : "ccw",
                         measure::to_text(run.direction));
    case FaultKind::angle_zero:
      return fmt::format("with angles that begin {:.1f} deg further on", value / kDeg);
    case FaultKind::centre:
      return fmt::format("with centre_mm [{}] instead of [{}]", place_text(fault.values, kMm, 1), centre_text(run));
    case FaultKind::tilt:
      return fmt::format("with tilt_deg [{}] instead of [{}]", place_text(fault.values, kDeg, 2), tilt_text(run));
    case FaultKind::payload:
      return fmt::format("with payload_kg {:.2f} instead of {:.4g}", value, run.payload_mass);
    case FaultKind::radius:
      return fmt::format("with radius_mm {:.2f} instead of {:.6g}", value / kMm, run.radius / kMm);
    case FaultKind::bar_length:
      return fmt::format("with bar_mm {:.1f} instead of {:.6g}", value / kMm, run.bar_length() / kMm);
    case FaultKind::exchanged:
      return fmt::format("with what the dataset says of run {}", runs[fault.like].id);
    default:
      return "";
  }
}

std::string channels_text(const Fault& fault) {
  const std::string of = channel_text(fault.channels);
  const double value = fault.values.empty() ? 0 : fault.values[0];
  switch (fault.kind) {
    case FaultKind::bar_sign:
      return "with the sign of the bar turned around";
    case FaultKind::bar_unit:
      return fmt::format("with readings of the bar divided by {:.4g} (another unit?)", value);
    case FaultKind::motor_sign:
      return fmt::format("with the sign of {} turned around", of);
    case FaultKind::motors_swapped:
      if (!fault.values.empty()) {
        return fmt::format("with motors {} read in the columns of {}", fmt::join(fault.channels, ", "),
                           fmt::join(fault.values, ", "));
      }
      return fmt::format("with {} exchanged", of);
    case FaultKind::torque_unit:
      return fmt::format("with {} divided by {:.4g} (a current, or per cent of rated?)", of, value);
    case FaultKind::clock:
      return fmt::format("with {} taken {:.3g} s {}", of, std::abs(value), value > 0 ? "later" : "earlier");
    case FaultKind::drift:
      return fmt::format("without a drift of the bar by {:.2f} um within the run", value / kUm);
    case FaultKind::bar_step:
      return fmt::format("without a step of the bar by {:.2f} um at {:.0f} deg", value / kUm,
                         fault.values.at(1) / kDeg);
    case FaultKind::motor_zero:
      return fmt::format("without {:.3f} N m that {} reads too much", value, of);
    default:
      return "";
  }
}

std::string periodic_text(const Fault& fault) {
  const double sampling = fault.values.at(2);
  std::string text =
      fmt::format("a periodic disturbance at {:.3f} Hz (or what is folded there: n x {:.3f} Hz more or less)",
                  fault.values.at(0), sampling);
  if (fault.channels[0] == identify::kRadial) {
    text += fmt::format(", {:.2f} um at the bar", fault.values.at(1) / kUm);
    text += fault.values.size() > 3 ? fmt::format(", along {:.0f} deg from +X", fault.values[3] / kDeg)
                                    : std::string(", alike all around");
  } else {
    text += fmt::format(", {:.3f} N m in motor {}", fault.values.at(1), fault.channels[0]);
  }
  return text + "; it is kept out of everything else";
}

// Of so many of it a um.
std::string_view larger_unit(double per_um) {
  if (per_um == 1e-3) return "mm";
  return per_um < 1e-3 ? "inches" : "thousandths of an inch";
}

std::string gaps_text(double gap, double empty) {
  std::string text;
  if (gap > 0) text = fmt::format("there is a gap of {:.0f} deg", gap / kDeg);
  if (empty > 0) {
    text += fmt::format("{}{:.0f} {} without a reading {} left out", text.empty() ? "" : ", ", empty,
                        empty == 1 ? "row" : "rows", empty == 1 ? "is" : "are");
  }
  return text;
}

std::string noise_text(const Fault& fault) {
  const double found = fault.values.at(0);
  const double stated = fault.values.at(1);
  if (fault.channels[0] == identify::kRadial) {
    return fmt::format("the noise of the bar is {:.2f} um, and its instrument states {:.2f} um", found / kUm,
                       stated / kUm);
  }
  return fmt::format("the noise of the torques is {:.3f} N m, and their instrument states {:.3f} N m", found, stated);
}

std::string record_text(const Fault& fault, const Run& run, const std::vector<Run>& runs) {
  const double value = fault.values.empty() ? 0 : fault.values[0];
  const std::string of = channel_text(fault.channels);
  switch (fault.kind) {
    case FaultKind::direction:
      return fmt::format("its angles go {}, and the dataset says otherwise", measure::to_text(run.direction));
    case FaultKind::feed:
      return fmt::format("its table goes around at {:.4g} mm/min, and the dataset says otherwise", value / kMmPerMin);
    case FaultKind::stuck:
      return fmt::format("{} stands still: {:.0f} samples one after the other are alike", of, value);
    case FaultKind::clipped:
      return fmt::format("{} is cut off: {:.0f} samples one after the other stand at its end", of, value);
    case FaultKind::noisy:
      return fmt::format("{} is {:.1f} times as noisy as in other runs", of, value);
    case FaultKind::same_readings:
      return fmt::format("it has the same readings as run {}", runs[fault.like].id);
    case FaultKind::motors_alike:
      return fmt::format("motor {} has the same readings as motor {}", fault.channels.at(0), fault.channels.at(1));
    case FaultKind::motors_unsigned:
      return "no torque is negative, and they follow the size of what the model predicts: their signs are lost";
    case FaultKind::motor_silent:
      return fmt::format("{} reads noise: a sample says nothing of the next one, where other motors follow the way",
                         of);
    case FaultKind::start:
      return fmt::format(
          "start_s is no time in s on one clock: run {} would begin at {:.6g} s, and run {}, from {:.6g} s on, takes "
          "{:.4g} s",
          run.id, value, runs[fault.like].id, fault.values.at(1), fault.values.at(2));
    case FaultKind::spikes:
      return fmt::format("{:.0f} {} left out as spikes", value, value == 1 ? "sample is" : "samples are");
    case FaultKind::gaps:
      return gaps_text(value, fault.values.at(1));
    case FaultKind::periodic:
      return periodic_text(fault);
    case FaultKind::noise:
      return noise_text(fault);
    case FaultKind::bar_unit:
      if (fault.values.size() < 2) {
        return fmt::format(
            "readings of the bar are {:.2g} of what the model predicts, and follow it: they are in {}, not in um",
            value, larger_unit(value));
      }
      return fmt::format(
          "readings of the bar are {:.2g} of what the model predicts, their noise is {:.1g} um, less than any bar has: "
          "they are in {}, not in um",
          value, fault.values.at(1) / kUm, larger_unit(value));
    case FaultKind::drift:
      return fmt::format(
          "the bar drifts within each run, by some {:.2f} um: no machine does that alike wherever a run begins",
          value / kUm);
    case FaultKind::unreachable:
      return "the machine cannot stand where the dataset says: check centre, radius and tilt, and the lengths of "
             "struts in the model";
    default:
      return fmt::format("it stands out, {} most: {:.1f} times the noise, and nothing that was tried explains it", of,
                         fault.before);
  }
}

}  // namespace

std::string fault_text(const Fault& fault, const std::vector<Run>& runs) {
  const Run& run = runs[fault.runs.front()];
  const bool of_each = fault.after > 0 || fault.kind == FaultKind::periodic || fault.kind == FaultKind::motors_alike;
  const bool several = !fault.all && of_each && fault.runs.size() > 1;
  std::string text = fault.all ? "all runs: " : fmt::format("run {}: ", run.id);
  if (several) {
    text = fmt::format("runs {}: ", runs_text(fault.runs, runs));
  }
  if (fault.after == 0 || fault.kind == FaultKind::stands_out || fault.kind == FaultKind::noisy) {
    return text + record_text(fault, run, runs);
  }
  std::string label = label_text(fault, run, runs);
  const bool place = fault.kind == FaultKind::centre || fault.kind == FaultKind::tilt;
  if (place && fault.runs.size() > 1) label += fmt::format(" in run {}, and so in the others,", run.id);
  const bool little = fmt::format("{:.1f}", fault.after) == fmt::format("{:.1f}", fault.before);
  const int digits = little ? 3 : 1;
  text +=
      fmt::format("{} {} at {:.{}f} times the noise instead of {:.{}f}", label.empty() ? channels_text(fault) : label,
                  fault.all || several ? "they are" : "it is", fault.after, digits, fault.before, digits);
  if (little) text += fmt::format(", which makes the readings likelier by {:.0f} nats", fault.nats);
  std::vector<std::string_view> others;
  for (const FaultKind kind : fault.or_these) others.push_back(to_text(kind));
  if (!others.empty()) text += fmt::format("; {} would explain it about as well", fmt::join(others, ", "));
  if (fault.may_be_effect) text += "; other runs are off by as much, as an effect makes them that the model lacks";
  return text;
}

std::string faults_text(const inspect::Inspection& inspection, const std::vector<Run>& runs) {
  std::string text = inspection.faults.empty() ? "" : "of the data:\n";
  for (const Fault& fault : inspection.faults) text += "  " + fault_text(fault, runs) + "\n";
  return text;
}

std::string inspection_text(const inspect::Inspection& inspection, const std::vector<Run>& runs, bool with_model) {
  const auto blocking = std::count_if(inspection.faults.begin(), inspection.faults.end(),
                                      [](const Fault& fault) { return fault.blocks; });
  std::string text = blocking == 0   ? "nothing is wrong with the data, as far as they tell\n"
                     : blocking == 1 ? std::string("something is wrong with the data\n")
                                     : fmt::format("{} things are wrong with the data\n", blocking);
  for (const Fault& fault : inspection.faults) text += "  " + fault_text(fault, runs) + "\n";
  if (!with_model) {
    return text + "  no model was given (-m): the records alone were looked at, not whether they fit each other\n";
  }
  text += fmt::format("{:<24}{:>8}   times the noise, as the model and all other runs predict it\n", "run", "all");
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const inspect::RunMisfit& misfit = inspection.runs[r];
    text += fmt::format("{:<24}{:>8}\n", runs[r].id, misfit.all > 0 ? fmt::format("{:.2f}", misfit.all) : "-");
  }
  return text;
}

std::string inspection_json(const inspect::Inspection& inspection, const std::vector<Run>& runs) {
  using Json = nlohmann::ordered_json;
  Json json{{"plumbline", "inspection 1"}, {"clean", !inspection.blocks()}, {"faults", Json::array()}};
  for (const Fault& fault : inspection.faults) {
    Json one{{"kind", to_text(fault.kind)}, {"runs", Json::array()}, {"all", fault.all}};
    for (const std::size_t r : fault.runs) one["runs"].push_back(runs[r].id);
    if (fault.kind == FaultKind::same_readings || fault.kind == FaultKind::exchanged) one["like"] = runs[fault.like].id;
    one["channels"] = Json::array();
    for (const int channel : fault.channels) one["channels"].push_back(identify::channel_name(channel));
    one["values_si"] = fault.values;
    if (fault.before > 0) one.update({{"before", fault.before}, {"after", fault.after}, {"nats", fault.nats}});
    one["or"] = Json::array();
    for (const FaultKind kind : fault.or_these) one["or"].push_back(to_text(kind));
    one["blocks"] = fault.blocks;
    one["text"] = fault_text(fault, runs);
    json["faults"].push_back(one);
  }
  json["usual"] = inspection.usual;
  json["runs"] = Json::array();
  for (std::size_t r = 0; r < inspection.runs.size(); ++r) {
    Json channels = Json::object();
    for (std::size_t c = 0; c < inspection.runs[r].channels.size(); ++c) {
      if (inspection.runs[r].channels[c] > 0) {
        channels[std::string(identify::channel_name(static_cast<int>(c)))] = inspection.runs[r].channels[c];
      }
    }
    json["runs"].push_back({{"id", runs[r].id}, {"times_the_noise", inspection.runs[r].all}, {"channels", channels}});
  }
  return json.dump(1) + "\n";
}

}  // namespace plumbline::report
