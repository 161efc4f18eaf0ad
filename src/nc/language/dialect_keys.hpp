// What the keys of [syntax] and [habits] of a dialect's table are called. grammar/README.md says what they mean.
#pragma once

#include <string>
#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

/// A key, and the member that it sets.
template <class Member>
struct Key {
  std::string_view name;
  Member member;
};

inline constexpr Key<bool Syntax::*> kSyntaxFlags[] = {
    {"names", &Syntax::names},
    {"semicolon_ends", &Syntax::semicolon_ends},
    {"percent_text", &Syntax::percent_text},
    {"declared", &Syntax::declared},
    {"settings_alone", &Syntax::settings_alone},
    {"open_assignment", &Syntax::open_assignment},
    {"exponents", &Syntax::exponents},
    {"one_sign", &Syntax::one_sign},
    {"repeated_ijk", &Syntax::repeated_ijk},
    {"capitals", &Syntax::capitals},
    {"rounds_to_zero", &Syntax::rounds_to_zero},
    {"bitwise", &Syntax::bitwise},
    {"full_turn", &Syntax::full_turn},
    {"unsourced_values", &Syntax::unsourced_values},
    {"relations_last", &Syntax::relations_last},
    {"draws", &Syntax::draws},
    {"truths_only", &Syntax::truths_only},
    {"percent_pairs", &Syntax::percent_pairs},
    {"archive_heads", &Syntax::archive_heads},
    {"skip_switches", &Syntax::skip_switches},
    {"spindle_words", &Syntax::spindle_words},
    {"polar_words", &Syntax::polar_words},
    {"comma_corners", &Syntax::comma_corners},
    {"word_modes", &Syntax::word_modes},
    {"settings_at_once", &Syntax::settings_at_once},
    {"exists_numbers", &Syntax::exists_numbers},
    {"restates_lasting", &Syntax::restates_lasting},
    {"empty_names", &Syntax::empty_names},
    {"drops_vacant_words", &Syntax::drops_vacant_words},
    {"calls_by_name", &Syntax::calls_by_name},
    {"zero_calls_unknown", &Syntax::zero_calls_unknown},
    {"numbered_loops", &Syntax::numbered_loops},
    {"case_of_files", &Syntax::case_of_files},
};
inline constexpr Key<char Syntax::*> kSyntaxLetters[] = {
    {"call_letter", &Syntax::call_letter},
    {"program_letter", &Syntax::program_letter},
    {"open", &Syntax::open},
    {"goes_on", &Syntax::goes_on},
};
inline constexpr Key<double Syntax::*> kSyntaxNumbers[] = {
    {"equal_within", &Syntax::equal_within},
    {"relative_within", &Syntax::relative_within},
    {"doubtful_within", &Syntax::doubtful_within},
};
inline constexpr Key<int Syntax::*> kSyntaxIntegers[] = {
    {"local_variables", &Syntax::local_variables}, {"last_variable", &Syntax::last_variable},
    {"first_lasting", &Syntax::first_lasting},     {"last_lasting", &Syntax::last_lasting},
    {"alarm_variable", &Syntax::alarm_variable},   {"message_variable", &Syntax::message_variable},
};
inline constexpr Key<std::string Syntax::*> kSyntaxTexts[] = {
    {"reserved", &Syntax::reserved},
    {"travel_ends", &Syntax::travel_ends},
};

inline constexpr Key<bool ControlBehaviour::*> kHabitFlags[] = {
    {"last_of_group", &ControlBehaviour::last_of_group},
    {"starts_with_stops", &ControlBehaviour::starts_with_stops},
    {"cycles_exact_path", &ControlBehaviour::cycles_exact_path},
    {"length_set_at_start", &ControlBehaviour::length_set_at_start},
    {"unit_set_at_start", &ControlBehaviour::unit_set_at_start},
    {"bare_motion_code_is_mode", &ControlBehaviour::bare_motion_code_is_mode},
    {"bare_home_loses_position", &ControlBehaviour::bare_home_loses_position},
    {"rapid_before_codes", &ControlBehaviour::rapid_before_codes},
    {"group_0_takes_axes", &ControlBehaviour::group_0_takes_axes},
    {"no_work_system_at_start", &ControlBehaviour::no_work_system_at_start},
    {"always_point", &ControlBehaviour::always_point},
    {"increment_of_rest_unknown", &ControlBehaviour::increment_of_rest_unknown},
    {"keeps_increment", &ControlBehaviour::keeps_increment},
    {"round_keeps_increment", &ControlBehaviour::round_keeps_increment},
    {"zero_has_sign", &ControlBehaviour::zero_has_sign},
    {"m_beside_cut_unknown", &ControlBehaviour::m_beside_cut_unknown},
    {"change_beside_move_unknown", &ControlBehaviour::change_beside_move_unknown},
    {"inverse_time_by_radius", &ControlBehaviour::inverse_time_by_radius},
    {"helix_feed_along_circle", &ControlBehaviour::helix_feed_along_circle},
    {"feed_inch_increment_unknown", &ControlBehaviour::feed_inch_increment_unknown},
    {"machine_move_is_rapid", &ControlBehaviour::machine_move_is_rapid},
    {"offset_numbers_last", &ControlBehaviour::offset_numbers_last},
    {"machine_move_tool_unknown", &ControlBehaviour::machine_move_tool_unknown},
    {"home_ends_length", &ControlBehaviour::home_ends_length},
    {"unit_change_length_unknown", &ControlBehaviour::unit_change_length_unknown},
    {"h0_is_no_tool", &ControlBehaviour::h0_is_no_tool},
    {"length_needs_number", &ControlBehaviour::length_needs_number},
    {"tool_length_moves", &ControlBehaviour::tool_length_moves},
    {"unit_change_drops_feed", &ControlBehaviour::unit_change_drops_feed},
    {"tool_length_at_change", &ControlBehaviour::tool_length_at_change},
    {"fanuc_cycles", &ControlBehaviour::fanuc_cycles},
    {"passed_code_keeps_position", &ControlBehaviour::passed_code_keeps_position},
    {"call_with_moves", &ControlBehaviour::call_with_moves},
    {"table_increments", &ControlBehaviour::table_increments},
    {"end_returns", &ControlBehaviour::end_returns},
    {"turns_are_extra", &ControlBehaviour::turns_are_extra},
    {"inch_turn_unknown", &ControlBehaviour::inch_turn_unknown},
    {"inch_turn_per_revolution_unknown", &ControlBehaviour::inch_turn_per_revolution_unknown},
    {"dwell_unknown_per_revolution", &ControlBehaviour::dwell_unknown_per_revolution},
    {"dwell_unknown_inverse_time", &ControlBehaviour::dwell_unknown_inverse_time},
    {"h0_is_machine", &ControlBehaviour::h0_is_machine},
    {"return_levels", &ControlBehaviour::return_levels},
    {"increment_word_always", &ControlBehaviour::increment_word_always},
    {"cycle_off_stops_spindle", &ControlBehaviour::cycle_off_stops_spindle},
    {"rapid_after_cycles", &ControlBehaviour::rapid_after_cycles},
    {"inverse_time_arc_unknown", &ControlBehaviour::inverse_time_arc_unknown},
    {"radius_alone_stands", &ControlBehaviour::radius_alone_stands},
    {"set_position_unknown_elsewhere", &ControlBehaviour::set_position_unknown_elsewhere},
    {"radius_positive", &ControlBehaviour::radius_positive},
    {"turned_axis_alone_unknown", &ControlBehaviour::turned_axis_alone_unknown},
    {"dwell_takes_words", &ControlBehaviour::dwell_takes_words},
    {"feed_mode_drops_feed", &ControlBehaviour::feed_mode_drops_feed},
    {"change_stops_spindle", &ControlBehaviour::change_stops_spindle},
    {"even_spirals", &ControlBehaviour::even_spirals},
    {"arcs_turn", &ControlBehaviour::arcs_turn},
    {"local_shift_adds", &ControlBehaviour::local_shift_adds},
};
inline constexpr Key<double ControlBehaviour::*> kHabitNumbers[] = {
    {"increment_mm", &ControlBehaviour::increment_mm},
    {"increment_inch", &ControlBehaviour::increment_inch},
    {"increment_deg", &ControlBehaviour::increment_deg},
    {"inverse_time_increment", &ControlBehaviour::inverse_time_increment},
    {"feed_per_revolution_increment", &ControlBehaviour::feed_per_revolution_increment},
    {"increment_word_mm", &ControlBehaviour::increment_word_mm},
    {"increment_word_inch", &ControlBehaviour::increment_word_inch},
    {"increment_word_deg", &ControlBehaviour::increment_word_deg},
    {"peck_gap_mm", &ControlBehaviour::peck_gap_mm},
    {"chip_break_mm", &ControlBehaviour::chip_break_mm},
    {"dwell_p_s", &ControlBehaviour::dwell_p_s},
    {"travel_limit_mm", &ControlBehaviour::travel_limit_mm},
};
inline constexpr Key<int ControlBehaviour::*> kHabitIntegers[] = {
    {"most_digits", &ControlBehaviour::most_digits},
    {"feed_decimals", &ControlBehaviour::feed_decimals},
    {"most_m_codes", &ControlBehaviour::most_m_codes},
    {"least_calls", &ControlBehaviour::least_calls},
    {"call_repeat_digits", &ControlBehaviour::call_repeat_digits},
};
inline constexpr Key<std::string ControlBehaviour::*> kHabitTexts[] = {
    {"whole_words", &ControlBehaviour::whole_words},
    {"unknown_beside_unit", &ControlBehaviour::unknown_beside_unit},
};

}  // namespace plumbline::nc
