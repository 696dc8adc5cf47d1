// SPDX-License-Identifier: GPL-3.0-or-later
// Data-parallel kernels: the only door to OpenCL.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace scree {

/// An OpenCL device with its queue and a cache of compiled kernels, in memory and on disk under
/// $XDG_CACHE_HOME/scree (otherwise ~/.cache/scree). A damaged or unwritable disk cache is ignored.
/// PoCL on the CPU is the default; a GPU is used only when asked for. The device is opened on first
/// use, so any member may throw Error (resource). Not thread-safe: one caller at a time.
class Device {
  public:
    /// A buffer on the device; freed with its last handle.
    class Buffer;
    using BufferHandle = std::shared_ptr<Buffer>;
    using Argument = std::variant<BufferHandle, std::int32_t, std::uint32_t, std::uint64_t, float>;

    /// `name`: "" for the default (PoCL), "cpu", "gpu", an index of `names`, or part of a device's
    /// name. When none matches, the error of the first use lists the devices that exist.
    explicit Device(const std::string& name = "");
    ~Device();
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;

    /// "0: pthread-haswell (Portable Computing Language 3.1)", ...; empty without any device.
    static std::vector<std::string> names();

    const std::string& name() const; // the driver's name for it

    BufferHandle allocate(std::size_t bytes);
    void write(const BufferHandle& buffer, const void* data, std::size_t bytes);
    /// A buffer with the elements of a vector or a span; for none a few bytes, since OpenCL has no
    /// empty buffers.
    template <class Elements>
    BufferHandle upload(const Elements& elements) {
        const auto bytes = std::as_bytes(std::span(elements));
        BufferHandle buffer = allocate(std::max(bytes.size(), std::size_t{16}));
        if (!bytes.empty())
            write(buffer, bytes.data(), bytes.size());
        return buffer;
    }

    void read(const BufferHandle& buffer, void* data, std::size_t bytes);

    /// Runs `kernel` of `source` over a 1-D or 2-D range and waits. `source` is OpenCL C 1.2,
    /// compiled once, without contraction of a * b + c; the Error for a source that does not
    /// compile holds the compiler's log. `groups` is the work-group size, which must divide the
    /// range; when empty the device chooses it. PoCL may choose the whole range and keeps the
    /// private arrays of a group on one thread's stack, so kernels with such arrays must set it.
    void run(const std::string& source, const std::string& kernel,
             std::span<const std::size_t> global_size, std::span<const Argument> arguments,
             std::span<const std::size_t> groups = {});

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace scree
