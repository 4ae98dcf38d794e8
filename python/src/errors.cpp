#include "python/src/errors.h"

#include <new>
#include <regex>
#include <string>
#include <system_error>

#include "geometry/error.h"
#include "hsr/cli/memory_limit.h"

namespace hsr::python {

namespace {

PyObject* add(py::module_& module, const char* name, PyObject* base) {
  PyObject* type = PyErr_NewException((std::string("hsr.") + name).c_str(), base, nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, py::reinterpret_borrow<py::object>(type));
  return type;
}

// As long as the interpreter lives.
PyObject *input_error, *precondition_error, *invariant_error, *memory_limit;

}  // namespace

std::string without_dashes(const std::string& message) {
  std::string text;
  static const std::regex option("--([a-z]+(-[a-z]+)*)");
  auto at = std::sregex_iterator(message.begin(), message.end(), option);
  std::size_t end = 0;
  for (; at != std::sregex_iterator(); ++at) {
    const auto begin = static_cast<std::size_t>(at->position());
    text += message.substr(end, begin - end);
    std::string name = (*at)[1];
    for (char& c : name)
      if (c == '-') c = '_';
    text += name;
    end = begin + static_cast<std::size_t>(at->length());
  }
  return text + message.substr(end);
}

void add_errors(py::module_& module) {
  input_error = add(module, "InputError", PyExc_ValueError);
  precondition_error = add(module, "PreconditionError", PyExc_ValueError);
  invariant_error = add(module, "InvariantError", PyExc_RuntimeError);
  memory_limit = add(module, "MemoryLimit", PyExc_MemoryError);
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const InputError& e) {
      PyErr_SetString(input_error, without_dashes(e.what()).c_str());
    } catch (const PreconditionError& e) {
      PyErr_SetString(precondition_error, e.what());
    } catch (const InvariantError& e) {
      PyErr_SetString(invariant_error, (std::string("a defect of hsr, please report it: ") + e.what()).c_str());
    } catch (const std::bad_alloc&) {
      PyErr_SetString(memory_limit, cli::out_of_memory().c_str());
    } catch (const std::system_error&) {  // no thread could be started
      PyErr_SetString(memory_limit, cli::out_of_memory().c_str());
    }
  });
}

}  // namespace hsr::python
