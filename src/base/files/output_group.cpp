#include "base/files/output_group.hpp"

#include <cerrno>
#include <cstring>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/files/ending_signals.hpp"
#include "base/files/folder_lock.hpp"
#include "base/parallel.hpp"
#include "base/platform/platform.hpp"
#include "base/text/hash.hpp"

namespace plumbline {
namespace {

constexpr unsigned kNewMode = 0666;
constexpr unsigned kAtOnce = 16;  // that are synced: the disk writes what waits together as one

template <class Work>
std::optional<Diagnostic> problem_of(const Work& work) {
  try {
    work();
  } catch (const Refusal& refusal) {
    return refusal.diagnostic();
  }
  return std::nullopt;
}

}  // namespace

WaitingOutput::WaitingOutput(const std::string& name) : name_(name), target_(output_target(name)), hash_(fnv1a({})) {
  if (target_.kind != OutputTarget::Kind::file) refuse_write(ENOTSUP);
  const unsigned mode = target_.replaced ? target_.replaced->mode & kNewMode : kNewMode;
  file_ = make_temporary_file(target_.folder(), mode);
  if (!file_) refuse_write(errno);
}

void WaitingOutput::refuse_write(int error) const {
  Place place;
  place.file = name_;
  refuse("file-unwritable", fmt::format("cannot be written: {}", std::strerror(error)),
         way_out(error, fmt::format("check that {} exists, may be written to and has room", target_.folder())), place);
}

Destination WaitingOutput::destination() {
  return Destination::taken(name_, [this](std::string_view bytes) { write(bytes); });
}

void WaitingOutput::write(std::string_view bytes) {
  if (!write_all(file_->descriptor.number(), bytes.data(), bytes.size())) refuse_write(errno);
  hash_ = fnv1a(bytes, hash_);
  size_ += bytes.size();
}

void WaitingOutput::last() {
  if (target_.replaced) platform::adopt(file_->descriptor.number(), *target_.replaced);
  if (!platform::sync(file_->descriptor.number())) refuse_write(errno);
}

void WaitingOutput::appear() {
  if (!platform::rename(file_->name.path(), target_.path)) refuse_write(errno);
  file_->name.let_go();
}

void OutputGroup::make_last() {
  std::vector<One*> all;
  for (One& one : outputs_) all.push_back(&one);
  for_each_index(
      all.size(), [&](std::size_t i) { all[i]->problem = problem_of([&] { all[i]->output->last(); }); }, kAtOnce);
}

void OutputGroup::appear() {
  std::map<std::string, std::vector<One*>> folders;
  for (One& one : outputs_) {
    if (!one.problem) folders[one.output->target_.folder()].push_back(&one);
  }
  for (auto& [folder, ones] : folders) {
    const std::optional<Diagnostic> problem = problem_of([&, &in = folder, &all = ones] {
      const FolderLock lock(in, FolderLock::Kind::exclusive);
      const SignalsWait wait;
      for (One* const one : all) one->problem = problem_of([&] { one->output->appear(); });
      if (!lock.sync()) all.front()->output->refuse_write(errno);
    });
    if (!problem) continue;
    for (One* const one : ones) one->problem = problem;
  }
}

const std::optional<Diagnostic>& OutputGroup::problem(const WaitingOutput& output) const {
  for (const One& one : outputs_) {
    if (one.output == &output) return one.problem;
  }
  PLUMBLINE_CHECK(false);
  static const std::optional<Diagnostic> none;
  return none;
}

}  // namespace plumbline
