#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "codec.hpp"
#include "common/course/not_implemented.hpp"
#include "contract.hpp"
#include "remote.hpp"

// The program that a student's object is linked into: it answers one request after the other until
// there is no more. All of it runs in the student's process, so nothing here is trusted. The count
// of allocations, too, is the student's word: one who calls malloc by himself, or writes to the
// counter, is not counted. It tells honest work apart and no more.

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;  // NOLINT
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }  // NOLINT
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);  // NOLINT
}

namespace grading {
namespace {

/// False at the end of all requests.
bool receive(void* to, std::size_t size) {
  auto* place = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t count = read(request_descriptor, place, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    place += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool send(const std::string& bytes) {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = write(answer_descriptor, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

template <auto function>
void answer(Reader& from, Writer& to, std::uint64_t& allocated) {
  using Call = Signature<decltype(function)>;
  const auto arguments = decoded<typename Call::Values>(from);
  const std::size_t before = allocations;
  const typename Call::Result result = std::apply(function, arguments);
  allocated = allocations - before;
  Codec<typename Call::Result>::write(to, result);
}

/// What came of the call, and the bytes of its result or the exception's text.
template <std::uint32_t limit, auto... functions>
Ending call(Contract<limit, functions...> /*contract*/, std::uint32_t index, Reader from,
            Writer& to, std::uint64_t& allocated) {
  using Answer = void (*)(Reader&, Writer&, std::uint64_t&);
  static constexpr std::array<Answer, sizeof...(functions)> table{&answer<functions>...};
  const auto text = [&](const std::exception& error, Ending ending) {
    const std::string words = error.what();
    to.add(words.data(), words.size());
    return ending;
  };
  try {
    table.at(index)(from, to, allocated);
    return Ending::value;
  } catch (const common::NotImplemented& error) {
    to.add(error.step_and_function().data(), error.step_and_function().size());
    return Ending::not_implemented;
  } catch (const std::invalid_argument& error) {
    return text(error, Ending::invalid_argument);
  } catch (const std::domain_error& error) {
    return text(error, Ending::domain_error);
  } catch (const std::bad_alloc&) {
    return Ending::out_of_memory;
  } catch (const std::exception& error) {
    return text(error, Ending::exception);
  } catch (...) {
    return Ending::exception;
  }
}

bool serve_one() {
  RequestHead request;
  if (!receive(&request, sizeof request)) return false;
  std::string bytes(request.size, '\0');
  if (!receive(bytes.data(), bytes.size())) return false;
  AnswerHead head;
  head.nonce = request.nonce;
  Writer result;
  head.ending = call(LabContract(), request.function, Reader(bytes), result, head.allocations);
  head.size = static_cast<std::uint32_t>(result.bytes().size());
  Writer whole;
  whole.add(&head, sizeof head);
  whole.add(result.bytes().data(), result.bytes().size());
  return send(whole.bytes());
}

}  // namespace
}  // namespace grading

int main() {
  while (grading::serve_one()) {
  }
  return 0;
}
