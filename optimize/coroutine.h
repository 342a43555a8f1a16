// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <exception>
#include <functional>
#include <optional>
#include <semaphore>
#include <thread>
#include <utility>

namespace ballonet::optimize
{

/// A function that runs on a thread of its own but only in turns with its owner: it stops wherever it yields a request
/// and goes on when the owner resumes it with the answer. Turns a library that calls back into one that can be asked.
/// Never do two of the threads run at once, so nothing needs a lock and nothing depends on timing.
template <class Request, class Answer>
class Coroutine
{
public:
  /// Hands a request to the owner, waits, returns the answer. Throws Stopped if the owner gave up.
  using Yield = std::function<Answer(Request)>;

  /// Thrown by Yield to unwind the function when the owner is destroyed first.
  struct Stopped {
  };

  explicit Coroutine(std::function<void(const Yield &)> body) : thread_([this, body = std::move(body)] { run(body); })
  {
  }

  Coroutine(const Coroutine &) = delete;
  Coroutine &operator=(const Coroutine &) = delete;

  ~Coroutine()
  {
    stopping_ = true;
    owner_done_.release();
    thread_.join();
  }

  /// Lets the function run to its next request. Nothing if it has returned; what it throws is thrown here.
  /// After the first time, give the answer to the last request first.
  std::optional<Request> resume()
  {
    if (finished_)
      return std::nullopt;
    owner_done_.release();
    body_done_.acquire();
    if (error_)
      std::rethrow_exception(std::exchange(error_, nullptr));
    return std::exchange(request_, std::nullopt);
  }

  /// The answer to the last request.
  void answer(Answer answer) { answer_ = std::move(answer); }

private:
  void run(const std::function<void(const Yield &)> &body)
  {
    owner_done_.acquire();
    try {
      if (!stopping_)
        body([this](Request request) { return yield(std::move(request)); });
    } catch (const Stopped &) {
    } catch (...) {
      error_ = std::current_exception();
    }
    finished_ = true;
    body_done_.release();
  }

  Answer yield(Request request)
  {
    if (stopping_)
      throw Stopped();
    request_ = std::move(request);
    body_done_.release();
    owner_done_.acquire();
    if (stopping_)
      throw Stopped();
    return std::move(answer_);
  }

  std::optional<Request> request_;
  Answer answer_;
  std::exception_ptr error_;
  bool finished_ = false, stopping_ = false;
  std::binary_semaphore owner_done_{0}, body_done_{0};
  std::thread thread_; // last: runs on the members above
};

} // namespace ballonet::optimize
