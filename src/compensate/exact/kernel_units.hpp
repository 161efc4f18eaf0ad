// The kernel, compiled once for each kind of processor: each unit may use what its processor has, so it gives nothing
// to the rest of the program but the functions named here (tests/architecture/kernel_units_test.py).
#pragma once

#include "compensate/exact/pose_block.hpp"
#include "compensate/exact/setup.hpp"

namespace plumbline::compensate::exact {

void correct_one_by_one(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses);
void play_one_by_one(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                     std::size_t poses);
void correct_on_any(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses);
void play_on_any(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                 std::size_t poses);
void carry_one_by_one(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                      std::size_t poses);
void carry_on_any(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                  std::size_t poses);

#ifdef PLUMBLINE_X86_64_UNITS
void correct_on_x86_64_v2(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses);
void play_on_x86_64_v2(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                       std::size_t poses);
void carry_on_x86_64_v2(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                        std::size_t poses);
void correct_on_x86_64_v3(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses);
void play_on_x86_64_v3(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                       std::size_t poses);
void correct_on_x86_64_v4(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t poses);
void play_on_x86_64_v4(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                       std::size_t poses);
void carry_on_x86_64_v3(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                        std::size_t poses);
void carry_on_x86_64_v4(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                        std::size_t poses);

/// Whether this processor has all that a unit may use.
inline bool has_x86_64_v2() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("popcnt");
}
inline bool has_x86_64_v3() {
  return has_x86_64_v2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}
inline bool has_x86_64_v4() {
  return has_x86_64_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
#endif

}  // namespace plumbline::compensate::exact
