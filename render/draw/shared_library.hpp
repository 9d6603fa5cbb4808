#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace render {

/// A library opened at run time, its symbols kept apart from all others': OSMesa and EGL export the
/// same names. It stays open until the program ends, since Mesa's threads may outlive a context.
class SharedLibrary {
 public:
  /// Opens the first that exists; else throws std::runtime_error "needs PACKAGE: reason".
  SharedLibrary(std::initializer_list<const char*> files, const std::string& package) {
    std::string reason;
    for (const char* file : files) {
      handle_ = dlopen(file, RTLD_LOCAL | RTLD_NOW);
      if (handle_ != nullptr) return;
      if (reason.empty()) reason = dlerror();
    }
    throw std::runtime_error("needs " + package + ": " + reason);
  }

  /// The function of that name; throws std::runtime_error where there is none.
  template <typename Function>
  Function function(const char* name) const {
    void* symbol = dlsym(handle_, name);
    if (symbol == nullptr) throw std::runtime_error(std::string("the library lacks ") + name);
    return reinterpret_cast<Function>(symbol);
  }

 private:
  void* handle_ = nullptr;
};

}  // namespace render
