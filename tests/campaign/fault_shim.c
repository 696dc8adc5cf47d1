// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into the program: lets the call number $FAULT_AT of the kind $FAULT_KIND fail, and
// writes how many there were to $FAULT_COUNTS. Only files that are open for writing count, and
// allocations of the process itself, not those of its children.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>

enum { kind_open, kind_write, kind_fsync, kind_rename, kind_close, kind_malloc, kinds };
static const char* const names[kinds] = {"open", "write", "fsync", "rename", "close", "malloc"};
static atomic_long counts[kinds];
static int failing = -1;
static long failing_at = 0;
static pid_t process = 0;
static atomic_char written[4096]; // descriptors that are open for writing

#define REAL(name) ((__typeof__(&name))real(#name))

static void* real(const char* name) { return dlsym(RTLD_NEXT, name); }

static int fails(int kind, int error) {
    if (process == 0 || getpid() != process)
        return 0;
    if (atomic_fetch_add(&counts[kind], 1) + 1 != failing_at || kind != failing)
        return 0;
    errno = error;
    return 1;
}

static void write_counts(void) {
    const char* path = getenv("FAULT_COUNTS");
    if (path == NULL || getpid() != process)
        return;
    process = 0;
    FILE* out = REAL(fopen)(path, "w");
    for (int k = 0; out != NULL && k < kinds; ++k)
        fprintf(out, "%s %ld\n", names[k], (long)counts[k]);
    if (out != NULL)
        REAL(fclose)(out);
}

__attribute__((constructor)) static void start(void) {
    const char* kind = getenv("FAULT_KIND");
    const char* at = getenv("FAULT_AT");
    for (int k = 0; kind != NULL && k < kinds; ++k)
        if (strcmp(kind, names[k]) == 0)
            failing = k;
    failing_at = at != NULL ? atol(at) : 0;
    atexit(write_counts);
    process = getpid();
}

static int is_written(int fd) { return fd >= 0 && fd < 4096 && written[fd]; }

static int opened(int fd, int writes) {
    if (fd >= 0 && fd < 4096)
        written[fd] = (char)writes;
    return fd;
}

static int opens_to_write(int flags) { return (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0; }

#define DEFINE_OPEN(name)                                                                          \
    int name(const char* path, int flags, ...) {                                                   \
        va_list rest;                                                                              \
        va_start(rest, flags);                                                                     \
        const mode_t mode = va_arg(rest, mode_t);                                                  \
        va_end(rest);                                                                              \
        const int writes = opens_to_write(flags);                                                  \
        if (writes && fails(kind_open, EMFILE))                                                    \
            return -1;                                                                             \
        return opened(REAL(name)(path, flags, mode), writes);                                      \
    }
DEFINE_OPEN(open)
DEFINE_OPEN(open64)

#define DEFINE_FOPEN(name)                                                                         \
    FILE* name(const char* path, const char* mode) {                                               \
        const int writes = strpbrk(mode, "wa+") != NULL;                                           \
        if (writes && fails(kind_open, EMFILE))                                                    \
            return NULL;                                                                           \
        FILE* file = REAL(name)(path, mode);                                                       \
        if (file != NULL)                                                                          \
            opened(fileno(file), writes);                                                          \
        return file;                                                                               \
    }
DEFINE_FOPEN(fopen)
DEFINE_FOPEN(fopen64)

ssize_t write(int fd, const void* bytes, size_t count) {
    if (is_written(fd) && fails(kind_write, ENOSPC))
        return -1;
    return REAL(write)(fd, bytes, count);
}

ssize_t writev(int fd, const struct iovec* parts, int count) {
    if (is_written(fd) && fails(kind_write, ENOSPC))
        return -1;
    return REAL(writev)(fd, parts, count);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* file) {
    if (is_written(fileno(file)) && fails(kind_write, ENOSPC))
        return 0;
    return REAL(fwrite)(bytes, size, count, file);
}

int fsync(int fd) { return fails(kind_fsync, EIO) ? -1 : REAL(fsync)(fd); }

int rename(const char* from, const char* to) {
    return fails(kind_rename, EACCES) ? -1 : REAL(rename)(from, to);
}

int close(int fd) {
    const int fail = is_written(fd) && fails(kind_close, EIO);
    opened(fd, 0);
    const int result = REAL(close)(fd);
    if (fail)
        errno = EIO;
    return fail ? -1 : result;
}

int fclose(FILE* file) {
    const int fail = is_written(fileno(file)) && fails(kind_close, EIO);
    opened(fileno(file), 0);
    const int result = REAL(fclose)(file);
    if (fail)
        errno = EIO;
    return fail ? EOF : result;
}

// dlsym allocates, so that the C library's own names are called.
extern void* __libc_malloc(size_t size);
void* malloc(size_t size) { return fails(kind_malloc, ENOMEM) ? NULL : __libc_malloc(size); }
