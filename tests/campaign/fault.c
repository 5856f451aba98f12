/* A disk that fails, for one program: LD_PRELOAD=fault.so, ICEBOW_FAULT="NAME ERRNO BYTES".
 *
 * Files whose path contains NAME take BYTES bytes in all; then every write to them fails with ERRNO, as a full or
 * broken disk would. "flock * 95" lets flock and file locks fail instead; "clock 0 60" sets the clock back by 60 s at
 * each look. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>
#include <fcntl.h>

static char wanted[256];
static int error_code;
static long long left;

__attribute__((constructor)) static void begin(void) {
  const char* text = getenv("ICEBOW_FAULT");
  if (!text || sscanf(text, "%255s %d %lld", wanted, &error_code, &left) < 2) wanted[0] = 0;
}

static int is_wanted(int file) {
  if (!wanted[0] || file < 0) return 0;
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t n = readlink(link, path, sizeof path - 1);
  if (n <= 0 || path[0] != '/') return 0;
  path[n] = 0;
  if (strstr(path, "/ompi.")) return 0; /* MPI's own, of the same name, in its session's directory */
  const char* name = strrchr(path, '/') + 1;
  return strstr(name, wanted) != NULL;
}

/* How many of the bytes the file takes; -1 with errno where none. */
static ssize_t allowed(int file, size_t bytes) {
  if (!is_wanted(file) || bytes == 0) return (ssize_t)bytes;
  const ssize_t n = left < (long long)bytes ? (ssize_t)left : (ssize_t)bytes;
  left -= n;
  if (n > 0) return n;
  errno = error_code;
  return -1;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* data, size_t bytes) {
  const ssize_t n = allowed(file, bytes);
  return n < 0 ? n : REAL(write)(file, data, (size_t)n);
}
ssize_t pwrite(int file, const void* data, size_t bytes, off_t at) {
  const ssize_t n = allowed(file, bytes);
  return n < 0 ? n : REAL(pwrite)(file, data, (size_t)n, at);
}
ssize_t pwrite64(int file, const void* data, size_t bytes, off64_t at) {
  const ssize_t n = allowed(file, bytes);
  return n < 0 ? n : REAL(pwrite64)(file, data, (size_t)n, at);
}
ssize_t writev(int file, const struct iovec* parts, int count) {
  size_t bytes = 0;
  for (int k = 0; k < count; ++k) bytes += parts[k].iov_len;
  const ssize_t n = allowed(file, bytes);
  if (n < 0) return n;
  if ((size_t)n == bytes) return REAL(writev)(file, parts, count);
  return count > 0 && parts[0].iov_len > 0
             ? REAL(write)(file, parts[0].iov_base, parts[0].iov_len < (size_t)n ? parts[0].iov_len : (size_t)n)
             : 0;
}
int fsync(int file) {
  if (is_wanted(file) && left <= 0) {
    errno = error_code;
    return -1;
  }
  return REAL(fsync)(file);
}
int clock_gettime(clockid_t which, struct timespec* now) {
  static long long looks;
  const int result = REAL(clock_gettime)(which, now);
  if (which == CLOCK_REALTIME && strcmp(wanted, "clock") == 0) now->tv_sec -= left * ++looks;
  return result;
}
time_t time(time_t* place) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (place) *place = now.tv_sec;
  return now.tv_sec;
}
int flock(int file, int operation) {
  if (strcmp(wanted, "flock") == 0) {
    errno = error_code;
    return -1;
  }
  return REAL(flock)(file, operation);
}
