// The edge of the library: what is thrown inside leaves it as an Error.
#pragma once

namespace plumbline::api {

/// To be called while an exception is handled: a Refusal, and a broken invariant, are thrown on as an Error, all others
/// as they are: they are the caller's, or the system's.
[[noreturn]] void throw_on();

template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (...) {
    throw_on();
  }
}

}  // namespace plumbline::api
