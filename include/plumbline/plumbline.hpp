// plumbline for other programs, C++17: version 1 of the interface.
//
// It says what the command says: the same words, texts and numbers. Texts are read from files or from memory and
// written to files, strings or streams. Nothing is read that was not named, but subprograms beside a program. Functions
// throw Error and nothing else of their own, and write nothing then; they do not print, keep no state and do not depend
// on the locale. Threads may call them at once.
//
// What stays while PLUMBLINE_INTERFACE is 1: names and meanings of all that is declared here, names and meanings of
// options, codes of diagnostics, keys of JSON and columns of tables. What may come: functions, options, codes, keys and
// columns. What may change with any release: words, digits of numbers within their stated errors. The namespace v1 is
// part of every symbol, so that a later interface can stand beside this one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <plumbline/export.h>
#include <plumbline/types.hpp>

#define PLUMBLINE_INTERFACE 1

namespace plumbline::api {
inline namespace v1 {

/// "0.1.0"
PLUMBLINE_API std::string version();

/// Corrects a program for a machine. Options are those of `plumbline compensate`, but files that it would write; "undo"
/// writes what was replaced beside an output that is a file, and `undo` anywhere. "settings" names a settings file,
/// here and below, "machine" one that it describes; if it names the machine's model, Model() may be given.
PLUMBLINE_API Result compensate(const Input& program, const Model& model, const Options& options, const Output& output,
                                const Output& undo = Output::nothing(), const Progress& progress = {});

/// All places where a program, compensated, breaks limits of the machine. found(): there are some. A warning says what
/// compensate would refuse. Options as of compensate, those of the output excepted.
PLUMBLINE_API Result check(const Input& program, const Model& model, const Options& options,
                           const Progress& progress = {});

/// How far the tool is moved away from where program `a` takes it by program `b`, whose blocks may be pieces of a's.
/// Options are those of the program ("work-offset", "tools", ...) and "tolerance-mm", "tolerance-deg". found(): an
/// axis is off by more than these, or blocks are out of line.
PLUMBLINE_API Result diff(const Input& a, const Input& b, const Options& options = {}, const Model& model = {},
                          const Progress& progress = {});

/// The motion of a program, one JSON object a line, mm and deg. What nobody gave is zero.
PLUMBLINE_API void trace(const Input& program, const Options& options, const Output& output, const Model& model = {},
                         const Progress& progress = {});

/// The original of a compensated program, byte for byte.
PLUMBLINE_API void restore(const Input& program, const Input& undo, const Output& output);

/// Plays a program, as it stands, on the model: a row of CSV for every point of the path. Options are those of the
/// program, "step-angle" and "step-length".
PLUMBLINE_API Result simulate(const Input& program, const Model& model, const Options& options, const Output& output,
                              const Progress& progress = {});
/// The same as numbers: the columns of the CSV; "motion" is 0 for rapids, 1 for cuts along lines, 2 for arcs.
PLUMBLINE_API Table simulate(const Input& program, const Model& model, const Options& options = {},
                             const Progress& progress = {});

/// The error of the tool tip, strut lengths and forces at poses, the machine at rest, as CSV from CSV.
PLUMBLINE_API Result error(const Input& poses, const Model& model, const Output& output);
/// The same as numbers: the columns of the CSV.
PLUMBLINE_API Table error(const std::vector<Pose>& poses, const Model& model);

/// Learns the model's parameters from circular tests: `dataset` is the path of a dataset.toml. Options: "stages",
/// "free", "force", "accept" (runs that are taken as they are, whatever is wrong with them). model() of the result is
/// refused where something speaks against it, as the command refuses to write it.
PLUMBLINE_API Result identify(const Model& model, const std::string& dataset, const Options& options = {});

/// Finds where the joints are and how long the struts: from circular tests, a tracker's poses (option "poses", which
/// need be no file), or both; `dataset` may be empty. Other options: "frame-known", "geometry-alone", "free",
/// "joint-sigma", "offset-sigma", "controller", "force", "accept".
PLUMBLINE_API Result calibrate(const Model& model, const std::string& dataset, const Options& options = {});

/// Finds which effect a model misses. Options: "without", "seed", "accept".
PLUMBLINE_API Result diagnose(const Model& model, const std::string& dataset, const Options& options = {});

/// A model against measurements. Option: "max-radial-um", above which found() is true.
PLUMBLINE_API Result compare(const Model& model, const std::string& dataset, const Options& options = {});

/// The model file of a machine from what is stated of it. Options: "name", "provenance", "rotation", "ini", "hal",
/// "home", "base-radius", "base-angles", "base-height", "base-joints", the same of "platform", and keys of the model
/// file as "strut.length_min_mm". What nobody states is assumed, and the model says so.
PLUMBLINE_API Result new_model(const Options& options);

/// What the code of a diagnostic means and what to do.
PLUMBLINE_API std::string explain(std::string_view code);
/// Every code and what it means in a sentence, a line each.
PLUMBLINE_API std::string explain();

}  // namespace v1
}  // namespace plumbline::api
