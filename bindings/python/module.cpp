// The Python module plumbline._core: the C++ interface, with texts as bytes. plumbline/__init__.py makes it Python's.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <plumbline/plumbline.hpp>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace api = plumbline::api;
namespace py = pybind11;

namespace {

using Poses = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What is read: a name, and the text, or none of a file.
struct Text {
  std::string name;
  std::optional<std::string> bytes;
};

/// An option and its value, which may be read from elsewhere.
using Option = std::pair<std::string, std::variant<std::string, Text>>;
using Options = std::vector<Option>;

/// Called with the work done and the whole of it, with the interpreter's lock held.
using Progress = std::optional<py::function>;

api::Input input(const Text& text) {
  return text.bytes ? api::Input::text(*text.bytes, text.name) : api::Input::file(text.name);
}

api::Options options_of(const Options& given) {
  api::Options options;
  for (const auto& [name, value] : given) {
    if (const Text* const text = std::get_if<Text>(&value)) {
      options.set(name, input(*text));
    } else {
      options.set(name, std::get<std::string>(value));
    }
  }
  return options;
}

api::Progress progress_of(const Progress& progress) {
  if (!progress) return {};
  return [&progress](std::uint64_t done, std::uint64_t total) {
    const py::gil_scoped_acquire locked;
    (*progress)(done, total);
  };
}

api::Model model_of(const api::Model* model) { return model == nullptr ? api::Model() : *model; }

/// Runs without the interpreter's lock.
template <class Work>
auto unlocked(const Work& work) {
  const py::gil_scoped_release released;
  return work();
}

std::vector<std::string> warnings(const api::Result& result) {
  std::vector<std::string> all;
  for (const api::Diagnostic& warning : result.warnings()) {
    all.push_back(api::Error(api::Error::Kind::refused, warning).json());
  }
  return all;
}

/// The columns and a view of the values, which Python owns from now on.
py::tuple table(api::Table made) {
  for (const api::Diagnostic& warning : made.warnings) {
    const std::string words = warning.message + " [" + warning.code + "]: " + warning.help;
    if (PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 2) != 0) throw py::error_already_set();
  }
  auto* const kept = new api::Table(std::move(made));
  const py::capsule owner(kept, [](void* data) { delete static_cast<api::Table*>(data); });
  const auto columns = static_cast<py::ssize_t>(kept->columns.size());
  const auto rows = static_cast<py::ssize_t>(kept->rows());
  return py::make_tuple(kept->columns, py::array_t<double>({rows, columns}, kept->values.data(), owner));
}

std::vector<api::Pose> poses_of(const Poses& array) {
  if (array.ndim() != 2 || array.shape(1) != 6) throw py::value_error("poses: expected an array of shape (n, 6)");
  std::vector<api::Pose> poses;
  const auto rows = array.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    poses.push_back({rows(i, 0), rows(i, 1), rows(i, 2), rows(i, 3), rows(i, 4), rows(i, 5)});
  }
  return poses;
}

void add_types(py::module_& m) {
  py::class_<Text>(m, "Text").def(py::init([](std::string name, std::optional<py::bytes> bytes) {
    return Text{std::move(name), bytes ? std::optional(std::string(*bytes)) : std::nullopt};
  }));
  py::class_<api::Model>(m, "Model")
      .def(py::init([](const Text& text) { return unlocked([&] { return api::Model(input(text)); }); }))
      .def_property_readonly("name", &api::Model::name)
      .def_property_readonly("hash", &api::Model::hash)
      .def_property_readonly("file", &api::Model::file)
      .def_property_readonly("bytes", [](const api::Model& model) { return py::bytes(model.text()); });
  py::class_<api::Result>(m, "Result")
      .def_property_readonly("json", &api::Result::json)
      .def_property_readonly("words", [](const api::Result& result) { return py::bytes(result.words()); })
      .def_property_readonly("warnings", &warnings)
      .def_property_readonly("found", &api::Result::found)
      .def_property_readonly("model", [](const api::Result& result) { return py::bytes(result.model()); });
}

// Errors become Python's, whose classes __init__.py hands over.
void add_errors(py::module_& m) {
  static py::object* const classes = new py::object(py::none());
  m.def("raise_as", [](py::object given) { *classes = std::move(given); });
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const api::Error& error) {
      const py::object type = (*classes)[py::int_(static_cast<int>(error.kind()))];
      const std::string what = error.what();  // a line of a program in it may be any bytes
      const auto shown = py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(what.data(), static_cast<py::ssize_t>(what.size()), "replace"));
      PyErr_SetObject(type.ptr(), py::make_tuple(error.json(), shown).ptr());
    }
  });
}

py::tuple compensate(const Text& program, const api::Model* model, const Options& options, bool keeps_undo,
                     const Progress& progress) {
  std::string text, undo;
  const api::Output undo_to = keeps_undo ? api::Output::text(undo) : api::Output::nothing();
  const api::Progress told = progress_of(progress);
  const api::Result done = unlocked([&] {
    return api::compensate(input(program), model_of(model), options_of(options), api::Output::text(text), undo_to,
                           told);
  });
  return py::make_tuple(done, py::bytes(text), py::bytes(undo));
}

void add_programs(py::module_& m) {
  m.def("compensate", &compensate);
  m.def("check", [](const Text& program, const api::Model* model, const Options& options, const Progress& progress) {
    const api::Progress told = progress_of(progress);
    return unlocked([&] { return api::check(input(program), model_of(model), options_of(options), told); });
  });
  m.def("diff", [](const Text& a, const Text& b, const api::Model* model, const Options& options) {
    return unlocked([&] { return api::diff(input(a), input(b), options_of(options), model_of(model)); });
  });
  m.def("trace", [](const Text& program, const api::Model* model, const Options& options) {
    std::string text;
    unlocked([&] { api::trace(input(program), options_of(options), api::Output::text(text), model_of(model)); });
    return py::bytes(text);
  });
  m.def("restore", [](const Text& program, const Text& undo) {
    std::string text;
    unlocked([&] { api::restore(input(program), input(undo), api::Output::text(text)); });
    return py::bytes(text);
  });
  m.def("simulate", [](const Text& program, const api::Model* model, const Options& options, const Progress& progress) {
    const api::Progress told = progress_of(progress);
    return table(unlocked([&] { return api::simulate(input(program), model_of(model), options_of(options), told); }));
  });
  m.def("error", [](const Poses& poses, const api::Model& model) {
    const std::vector<api::Pose> all = poses_of(poses);
    return table(unlocked([&] { return api::error(all, model); }));
  });
}

using Learn = api::Result (*)(const api::Model&, const std::string&, const api::Options&);

void add_learning(py::module_& m) {
  const auto add = [&](const char* name, Learn learn) {
    m.def(name, [learn](const api::Model& model, const std::string& dataset, const Options& options) {
      return unlocked([&] { return learn(model, dataset, options_of(options)); });
    });
  };
  add("identify", &api::identify);
  add("calibrate", &api::calibrate);
  add("diagnose", &api::diagnose);
  add("compare", &api::compare);
  m.def("new_model",
        [](const Options& options) { return unlocked([&] { return api::new_model(options_of(options)); }); });
  m.def("explain",
        [](const std::optional<std::string>& code) { return py::bytes(code ? api::explain(*code) : api::explain()); });
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.attr("version") = api::version();
  m.attr("interface") = PLUMBLINE_INTERFACE;
  add_types(m);
  add_errors(m);
  add_programs(m);
  add_learning(m);
}
