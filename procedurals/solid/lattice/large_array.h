// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <memory>
#include <new>

#include <sys/mman.h>

namespace scree {

struct FreeMemory {
    void operator()(void* memory) const { std::free(memory); }
};

template <class T>
using LargeArray = std::unique_ptr<T[], FreeMemory>;

/// An uninitialised array, on huge pages if the system supports them, which makes random access and
/// the first write faster. Aligned to at least 64 bytes.
template <class T>
LargeArray<T> large_array(std::size_t count) {
    constexpr std::size_t page = std::size_t(2) << 20;
    const std::size_t alignment = count * sizeof(T) >= page ? page : 64;
    const std::size_t size = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, size);
    if (memory == nullptr)
        throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (alignment == page)
        madvise(memory, size, MADV_HUGEPAGE); // optional: failures are ignored
#endif
    return LargeArray<T>(static_cast<T*>(memory));
}

} // namespace scree
