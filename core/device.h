// SPDX-License-Identifier: GPL-3.0-or-later
// Data-parallel kernels: the only door to OpenCL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace scree {

/// An OpenCL device with its queue and a cache of compiled kernels (in memory, and on disk under
/// $XDG_CACHE_HOME/scree). PoCL on the CPU is the default; GPUs are used when asked for or when
/// `name` is "gpu". Not thread-safe: one caller at a time.
class Device {
  public:
    /// A buffer on the device; freed with its last handle.
    class Buffer;
    using BufferHandle = std::shared_ptr<Buffer>;
    using Argument = std::variant<BufferHandle, std::int32_t, std::uint32_t, std::uint64_t, float>;

    /// `name`: "" for the default (PoCL), "cpu", "gpu", an index of `names`, or part of a device's
    /// name. Throws Error (resource) listing what there is.
    explicit Device(const std::string& name = "");
    ~Device();
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;

    static std::vector<std::string> names(); // "0: cpu-haswell (PoCL 3.1)", ...

    const std::string& name() const;

    BufferHandle allocate(std::size_t bytes);
    void write(const BufferHandle& buffer, const void* data, std::size_t bytes);
    void read(const BufferHandle& buffer, void* data, std::size_t bytes);

    /// Runs `kernel` of `source` over a 1-D or 2-D range and waits. `source` is compiled once.
    void run(const std::string& source, const std::string& kernel,
             std::span<const std::size_t> global_size, std::span<const Argument> arguments);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace scree
