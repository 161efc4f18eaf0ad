// The list of effects as a table that can be looked through at run time.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "physics/effects/list.hpp"

namespace plumbline::physics {

/// Whether the numbers of an effect, all of them given for each strut, move the length of their own strut and nothing
/// else, whatever the loads: such an effect says so by `own_strut_alone`.
template <class Effect>
inline constexpr bool moves_own_strut_alone = requires {
  Effect::own_strut_alone;
};

/// Whether an effect follows from accelerations or from the control's following, so that it hangs on how the control
/// shapes the speed: such an effect says so by `dynamic`.
template <class Effect>
inline constexpr bool is_dynamic = requires {
  Effect::dynamic;
};

struct EffectInfo {
  std::string_view name;
  std::span<const ParameterSpec> parameters;
  bool base;             // always there
  bool own_strut_alone;  // see moves_own_strut_alone
  bool dynamic;          // see is_dynamic

  /// How many numbers an instance has.
  int size() const;
  /// Where the numbers of a key begin; -1 if there is no such key.
  int offset_of(std::string_view key) const;
  /// The strut that a number of an instance belongs to, of keys that have some for each strut.
  int strut_of(int offset) const;
};

/// All effects, in the order of the list.
const std::array<EffectInfo, kEffects>& effect_infos();

/// The place of an effect in the list; kEffects if there is none of that name.
std::size_t effect_index(std::string_view name);

/// The names of the effects that a model file may name.
std::vector<std::string_view> catalogue_names();

/// Calls apply.template operator()<Effect>(index) for each effect of the list, at compile time.
template <class Apply>
void for_each_effect(Apply&& apply) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (apply.template operator()<std::tuple_element_t<I, Effects>>(I), ...);
  }
  (std::make_index_sequence<kEffects>{});
}

}  // namespace plumbline::physics
