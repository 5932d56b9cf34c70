// SPDX-License-Identifier: Apache-2.0
#include "executor/hooks.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

#include <dlfcn.h>
#include <pthread.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define JOUNCE_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define JOUNCE_SANITIZED
#endif

namespace {

thread_local constinit jounce::test::Noise counted{};

/// The function that this one stands before.
template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

jounce::test::Noise jounce::test::noise() {
  return counted;
}

#ifndef JOUNCE_SANITIZED

// glibc's own names of them; a sanitizer has its own heap.
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t bytes) {
  ++counted.heap;
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  ++counted.heap;
  return __libc_calloc(count, bytes);
}
void* realloc(void* memory, std::size_t bytes) {
  ++counted.heap;
  return __libc_realloc(memory, bytes);
}
void free(void* memory) {
  ++counted.heap;
  __libc_free(memory);
}
}

#else

void* operator new(std::size_t bytes) {
  ++counted.heap;
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  ++counted.heap;
  return std::malloc(bytes);
}
void operator delete(void* memory) noexcept {
  ++counted.heap;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  ++counted.heap;
  std::free(memory);
}

#endif

#ifndef __SANITIZE_THREAD__  // it must see the locks itself

extern "C" {
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  ++counted.locks;
  return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
  ++counted.locks;
  return real(mutex);
}
int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  static const auto real = next<int (*)(pthread_cond_t*)>("pthread_cond_signal");
  ++counted.locks;
  return real(condition);
}

ssize_t write(int file, const void* bytes, std::size_t count) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  ++counted.writes;
  return real(file, bytes, count);
}
ssize_t writev(int file, const iovec* parts, int count) {
  static const auto real = next<ssize_t (*)(int, const iovec*, int)>("writev");
  ++counted.writes;
  return real(file, parts, count);
}
ssize_t sendto(int socket, const void* bytes, std::size_t count, int flags, const sockaddr* to,
               socklen_t length) {
  using Real = ssize_t (*)(int, const void*, std::size_t, int, const sockaddr*, socklen_t);
  static const auto real = next<Real>("sendto");
  ++counted.writes;
  return real(socket, bytes, count, flags, to, length);
}
std::size_t fwrite(const void* items, std::size_t size, std::size_t count, std::FILE* file) {
  static const auto real =
      next<std::size_t (*)(const void*, std::size_t, std::size_t, std::FILE*)>("fwrite");
  ++counted.writes;
  return real(items, size, count, file);
}
}

#endif
