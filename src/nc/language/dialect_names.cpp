#include "nc/language/dialect_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"

namespace plumbline::nc {
namespace {

using ActionName = std::pair<std::string_view, Action>;
constexpr std::array kActions{
    ActionName{"refused", Action::refused},
    ActionName{"rapid", Action::rapid},
    ActionName{"feed", Action::feed},
    ActionName{"arc_cw", Action::arc_cw},
    ActionName{"arc_ccw", Action::arc_ccw},
    ActionName{"motion_off", Action::motion_off},
    ActionName{"dwell", Action::dwell},
    ActionName{"plane_xy", Action::plane_xy},
    ActionName{"plane_zx", Action::plane_zx},
    ActionName{"plane_yz", Action::plane_yz},
    ActionName{"inches", Action::inches},
    ActionName{"millimetres", Action::millimetres},
    ActionName{"absolute", Action::absolute},
    ActionName{"incremental", Action::incremental},
    ActionName{"arc_centre_absolute", Action::arc_centre_absolute},
    ActionName{"arc_centre_incremental", Action::arc_centre_incremental},
    ActionName{"inverse_time", Action::inverse_time},
    ActionName{"per_minute", Action::per_minute},
    ActionName{"per_revolution", Action::per_revolution},
    ActionName{"exact_path", Action::exact_path},
    ActionName{"exact_stop", Action::exact_stop},
    ActionName{"continuous", Action::continuous},
    ActionName{"compensation_off", Action::compensation_off},
    ActionName{"work_system", Action::work_system},
    ActionName{"set_table", Action::set_table},
    ActionName{"set_position", Action::set_position},
    ActionName{"clear_position", Action::clear_position},
    ActionName{"suspend_position", Action::suspend_position},
    ActionName{"restore_position", Action::restore_position},
    ActionName{"machine_coordinates", Action::machine_coordinates},
    ActionName{"go_home", Action::go_home},
    ActionName{"store_home", Action::store_home},
    ActionName{"tool_length", Action::tool_length},
    ActionName{"tool_length_by_words", Action::tool_length_by_words},
    ActionName{"tool_length_added", Action::tool_length_added},
    ActionName{"tool_length_off", Action::tool_length_off},
    ActionName{"change_tool", Action::change_tool},
    ActionName{"set_tool", Action::set_tool},
    ActionName{"stop", Action::stop},
    ActionName{"end", Action::end},
    ActionName{"orient_spindle", Action::orient_spindle},
    ActionName{"set_output", Action::set_output},
    ActionName{"read_input", Action::read_input},
    ActionName{"set_analog_output", Action::set_analog_output},
    ActionName{"cycle", Action::cycle},
    ActionName{"retract_to_start", Action::retract_to_start},
    ActionName{"retract_to_r", Action::retract_to_r},
    ActionName{"call_program", Action::call_program},
    ActionName{"end_program", Action::end_program},
    ActionName{"save_modes", Action::save_modes},
    ActionName{"forget_modes", Action::forget_modes},
    ActionName{"restore_modes", Action::restore_modes},
    ActionName{"save_modes_of_call", Action::save_modes_of_call},
    ActionName{"lose_position", Action::lose_position},
    ActionName{"modal_call", Action::modal_call},
    ActionName{"called_cycle", Action::called_cycle},
    ActionName{"swivel", Action::swivel},
    ActionName{"home_or_unit", Action::home_or_unit},
    ActionName{"arc_through_point", Action::arc_through_point},
    ActionName{"call_macro", Action::call_macro},
    ActionName{"set_work_table", Action::set_work_table},
    ActionName{"local_shift", Action::local_shift},
    ActionName{"turn_on", Action::turn_on},
    ActionName{"turn_off", Action::turn_off},
    ActionName{"tilted_plane", Action::tilted_plane},
    ActionName{"tool_on_plane", Action::tool_on_plane},
    ActionName{"frame_new", Action::frame_new},
    ActionName{"frame_added", Action::frame_added},
    ActionName{"feed_group", Action::feed_group},
    ActionName{"tolerance_cycle", Action::tolerance_cycle},
    ActionName{"transformation", Action::transformation},
    ActionName{"exact_stop_once", Action::exact_stop_once},
    ActionName{"work_system_by_word", Action::work_system_by_word},
    ActionName{"work_system_of_block", Action::work_system_of_block},
    ActionName{"tool_edge", Action::tool_edge},
    ActionName{"no_motion", Action::no_motion},
    ActionName{"surface_speed", Action::surface_speed},
    ActionName{"no_next_tool", Action::no_next_tool},
    ActionName{"tool_tip_on", Action::tool_tip_on},
    ActionName{"tool_tip_off", Action::tool_tip_off},
    ActionName{"return_level", Action::return_level},
    ActionName{"no_hole", Action::no_hole},
    ActionName{"cubic_spline", Action::cubic_spline},
    ActionName{"quadratic_spline", Action::quadratic_spline},
    ActionName{"nurbs_point", Action::nurbs_point},
    ActionName{"nurbs_end", Action::nurbs_end},
    ActionName{"synchronised", Action::synchronised},
    ActionName{"rigid_tap", Action::rigid_tap},
    ActionName{"probe", Action::probe},
    ActionName{"compensation_on", Action::compensation_on},
    ActionName{"spindle", Action::spindle},
    ActionName{"coolant", Action::coolant},
    ActionName{"override", Action::override_switch},
    ActionName{"position_spindle", Action::position_spindle},
    ActionName{"main_spindle", Action::main_spindle},
    ActionName{"speed_limit", Action::speed_limit},
};

constexpr std::array kStatements{
    std::pair<std::string_view, Statements>{"o_words", Statements::o_words},
    std::pair<std::string_view, Statements>{"macro_b", Statements::macro_b},
    std::pair<std::string_view, Statements>{"user_task", Statements::user_task},
    std::pair<std::string_view, Statements>{"high_level", Statements::high_level},
};

constexpr std::array kLabels{
    std::pair<std::string_view, Labels>{"numbers", Labels::numbers},
    std::pair<std::string_view, Labels>{"sequence_names", Labels::sequence_names},
    std::pair<std::string_view, Labels>{"names", Labels::names},
};

constexpr std::array kSystemVariables{
    std::pair<std::string_view, SystemVariables>{"rs274", SystemVariables::rs274},
    std::pair<std::string_view, SystemVariables>{"macro_b", SystemVariables::macro_b},
    std::pair<std::string_view, SystemVariables>{"none", SystemVariables::none},
};

constexpr std::array kGuards{
    std::pair<std::string_view, GuardLanguage>{"linuxcnc", GuardLanguage::linuxcnc},
    std::pair<std::string_view, GuardLanguage>{"macro_b", GuardLanguage::macro_b},
    std::pair<std::string_view, GuardLanguage>{"sinumerik", GuardLanguage::sinumerik},
};

constexpr std::array kKeywords{
    std::pair<std::string_view, FlowWord>{"if", FlowWord::begin_if},
    std::pair<std::string_view, FlowWord>{"else_if", FlowWord::else_if},
    std::pair<std::string_view, FlowWord>{"else", FlowWord::otherwise},
    std::pair<std::string_view, FlowWord>{"end_if", FlowWord::end_if},
    std::pair<std::string_view, FlowWord>{"go_to", FlowWord::go_to},
    std::pair<std::string_view, FlowWord>{"call", FlowWord::call},
    std::pair<std::string_view, FlowWord>{"return", FlowWord::give_back},
    std::pair<std::string_view, FlowWord>{"while", FlowWord::begin_while},
    std::pair<std::string_view, FlowWord>{"end_while", FlowWord::end_while},
    std::pair<std::string_view, FlowWord>{"for", FlowWord::begin_for},
    std::pair<std::string_view, FlowWord>{"end_for", FlowWord::end_for},
    std::pair<std::string_view, FlowWord>{"loop", FlowWord::begin_loop},
    std::pair<std::string_view, FlowWord>{"end_loop", FlowWord::end_loop},
    std::pair<std::string_view, FlowWord>{"repeat", FlowWord::begin_repeat},
    std::pair<std::string_view, FlowWord>{"until", FlowWord::until},
    std::pair<std::string_view, FlowWord>{"case", FlowWord::choose},
    std::pair<std::string_view, FlowWord>{"repeat_line", FlowWord::repeat_line},
    std::pair<std::string_view, FlowWord>{"external_call", FlowWord::external_call},
    std::pair<std::string_view, FlowWord>{"define", FlowWord::define},
    std::pair<std::string_view, FlowWord>{"subprogram", FlowWord::sub},
};

constexpr std::array kOperations{
    std::pair<std::string_view, Operation>{"number", Operation::number},  // of no argument: pi, or 1 and 0
    std::pair<std::string_view, Operation>{"vacant", Operation::vacant},
    std::pair<std::string_view, Operation>{"absolute", Operation::absolute},
    std::pair<std::string_view, Operation>{"arc_cosine", Operation::arc_cosine},
    std::pair<std::string_view, Operation>{"arc_sine", Operation::arc_sine},
    std::pair<std::string_view, Operation>{"arc_tangent", Operation::arc_tangent},
    std::pair<std::string_view, Operation>{"arc_tangent_of_one", Operation::arc_tangent_of_one},
    std::pair<std::string_view, Operation>{"cosine", Operation::cosine},
    std::pair<std::string_view, Operation>{"exponential", Operation::exponential},
    std::pair<std::string_view, Operation>{"truncate", Operation::truncate},
    std::pair<std::string_view, Operation>{"round_away", Operation::round_away},
    std::pair<std::string_view, Operation>{"round_up", Operation::round_up},
    std::pair<std::string_view, Operation>{"logarithm", Operation::logarithm},
    std::pair<std::string_view, Operation>{"round", Operation::round},
    std::pair<std::string_view, Operation>{"sine", Operation::sine},
    std::pair<std::string_view, Operation>{"square_root", Operation::square_root},
    std::pair<std::string_view, Operation>{"square", Operation::square},
    std::pair<std::string_view, Operation>{"tangent", Operation::tangent},
    std::pair<std::string_view, Operation>{"power", Operation::power},
    std::pair<std::string_view, Operation>{"logical_not", Operation::logical_not},
    std::pair<std::string_view, Operation>{"smaller", Operation::smaller},
    std::pair<std::string_view, Operation>{"larger", Operation::larger},
    std::pair<std::string_view, Operation>{"remainder", Operation::remainder},
    std::pair<std::string_view, Operation>{"whole_remainder", Operation::whole_remainder},
    std::pair<std::string_view, Operation>{"whole_quotient", Operation::whole_quotient},
    std::pair<std::string_view, Operation>{"equal", Operation::equal},
    std::pair<std::string_view, Operation>{"not_equal", Operation::not_equal},
    std::pair<std::string_view, Operation>{"greater", Operation::greater},
    std::pair<std::string_view, Operation>{"greater_equal", Operation::greater_equal},
    std::pair<std::string_view, Operation>{"less", Operation::less},
    std::pair<std::string_view, Operation>{"less_equal", Operation::less_equal},
    std::pair<std::string_view, Operation>{"logical_and", Operation::logical_and},
    std::pair<std::string_view, Operation>{"logical_or", Operation::logical_or},
    std::pair<std::string_view, Operation>{"exclusive_or", Operation::exclusive_or},
};

constexpr std::array kFeedRules{
    std::pair<std::string_view, FeedRule>{"xyz_first", FeedRule::xyz_first},
    std::pair<std::string_view, FeedRule>{"all_axes_as_mm", FeedRule::all_axes_as_mm},
    std::pair<std::string_view, FeedRule>{"tool_tip", FeedRule::tool_tip},
    std::pair<std::string_view, FeedRule>{"path_group", FeedRule::path_group},
    std::pair<std::string_view, FeedRule>{"unknown", FeedRule::unknown},
};

template <class Names>
auto named(const Names& names, std::string_view name) {
  const auto at = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == name; });
  if (at == names.end()) throw InternalError(fmt::format("in a dialect table: nothing is called '{}'", name));
  return at->second;
}

}  // namespace

Action action_named(std::string_view name) { return named(kActions, name); }
Statements statements_named(std::string_view name) { return named(kStatements, name); }
Labels labels_named(std::string_view name) { return named(kLabels, name); }
SystemVariables system_variables_named(std::string_view name) { return named(kSystemVariables, name); }
GuardLanguage guard_named(std::string_view name) { return named(kGuards, name); }
FlowWord keyword_named(std::string_view name) { return named(kKeywords, name); }
Operation operation_named(std::string_view name) { return named(kOperations, name); }
FeedRule feed_rule_named(std::string_view name) { return named(kFeedRules, name); }

}  // namespace plumbline::nc
