// SPDX-License-Identifier: GPL-3.0-or-later
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include "core/device.h"

#include "core/error.h"
#include "core/file.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace scree {

namespace {

void check(cl_int status, const char* what) {
    if (status != CL_SUCCESS)
        throw Error::resource(fmt::format("OpenCL: {} failed with error {}", what, status));
}

struct Found {
    cl_device_id id;
    cl_device_type type;
    std::string name;
    std::string platform; // "Portable Computing Language"
    std::string driver;   // version of the driver
};

/// A text that OpenCL answers, such as a name: `ask(size, buffer, size_of_it)`.
template <class Ask>
std::string answered_text(const Ask& ask) {
    std::size_t size = 0;
    check(ask(0, nullptr, &size), "asking for a name");
    std::string text(size, '\0');
    check(ask(size, text.data(), nullptr), "asking for a name");
    text.resize(std::min(text.size(), text.find('\0')));
    return text;
}

std::string device_text(cl_device_id id, cl_device_info what) {
    return answered_text([&](std::size_t size, char* text, std::size_t* used) {
        return clGetDeviceInfo(id, what, size, text, used);
    });
}

std::string platform_text(cl_platform_id id, cl_platform_info what) {
    return answered_text([&](std::size_t size, char* text, std::size_t* used) {
        return clGetPlatformInfo(id, what, size, text, used);
    });
}

std::vector<Found> find_devices() {
    cl_uint platform_count = 0;
    // The loader returns an error when there is no platform; we return an empty list.
    if (clGetPlatformIDs(0, nullptr, &platform_count) != CL_SUCCESS)
        return {};
    std::vector<cl_platform_id> platforms(platform_count);
    check(clGetPlatformIDs(platform_count, platforms.data(), nullptr), "listing platforms");
    std::vector<Found> found;
    for (const cl_platform_id platform : platforms) {
        cl_uint count = 0;
        if (clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS)
            continue;
        std::vector<cl_device_id> ids(count);
        check(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, ids.data(), nullptr),
              "listing devices");
        for (const cl_device_id id : ids) {
            cl_device_type type = 0;
            check(clGetDeviceInfo(id, CL_DEVICE_TYPE, sizeof type, &type, nullptr),
                  "asking a device");
            found.push_back({id, type, device_text(id, CL_DEVICE_NAME),
                             platform_text(platform, CL_PLATFORM_NAME),
                             device_text(id, CL_DRIVER_VERSION)});
        }
    }
    return found;
}

std::string listing(const std::vector<Found>& devices) {
    std::string text;
    for (std::size_t i = 0; i < devices.size(); ++i)
        text += fmt::format("{}{}: {} ({} {})", i == 0 ? "" : ", ", i, devices[i].name,
                            devices[i].platform, devices[i].driver);
    return text.empty() ? "none; install an OpenCL driver, for example pocl-opencl-icd" : text;
}

Found choose_device(const std::string& wanted) {
    const std::vector<Found> devices = find_devices();
    const auto pick = [&](const auto& fits) {
        const auto found = std::ranges::find_if(devices, fits);
        return found == devices.end() ? nullptr : &*found;
    };
    const auto of_type = [&](cl_device_type type) {
        return pick([type](const Found& device) { return (device.type & type) != 0; });
    };
    const std::string name = lower_case(wanted);
    const Found* chosen = nullptr;
    if (name.empty()) {
        chosen = pick([](const Found& device) {
            return device.platform == "Portable Computing Language" &&
                   (device.type & CL_DEVICE_TYPE_CPU) != 0;
        });
        if (chosen == nullptr && !devices.empty())
            chosen = &devices.front();
    } else if (name == "cpu") {
        chosen = of_type(CL_DEVICE_TYPE_CPU);
    } else if (name == "gpu") {
        chosen = of_type(CL_DEVICE_TYPE_GPU);
    } else if (name.size() < 4 &&
               std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; })) {
        const std::size_t index = std::stoul(name);
        chosen = index < devices.size() ? &devices[index] : nullptr;
    } else {
        chosen = pick([&](const Found& device) {
            return lower_case(device.name).find(name) != std::string::npos;
        });
    }
    if (chosen == nullptr)
        throw Error::resource(fmt::format("no OpenCL device{}; devices here: {}",
                                          wanted.empty() ? "" : " \"" + wanted + "\"",
                                          listing(devices)));
    return *chosen;
}

/// Keeps compiled kernels between runs, one file each. Failures here are ignored: they only cost
/// the time to compile.
class BinaryCache {
  public:
    explicit BinaryCache(std::string key) {
        const char* cache = std::getenv("XDG_CACHE_HOME");
        const char* home = std::getenv("HOME");
        if (cache != nullptr && *cache == '/')
            folder_ = std::string(cache) + "/scree";
        else if (home != nullptr && *home != '\0')
            folder_ = std::string(home) + "/.cache/scree";
        if (!folder_.empty())
            path_ = fmt::format("{}/kernel-{:016x}", folder_, hash_bytes(key));
        key_ = std::move(key);
    }

    /// A file holds the whole key, so that a hash collision is noticed, then the hash of the
    /// binary, so that a damaged binary never reaches the driver, then the binary.
    std::string load() const {
        if (path_.empty())
            return {};
        try {
            const std::string bytes = read_file(path_, std::uint64_t{256} << 20);
            const std::size_t at = key_.size() + hash_digits;
            if (bytes.size() <= at || bytes.compare(0, key_.size(), key_) != 0)
                return {};
            std::string binary = bytes.substr(at);
            return bytes.compare(key_.size(), hash_digits, digits(binary)) == 0 ? binary : "";
        } catch (const Error&) {
            return {};
        }
    }

    void store(const std::string& binary) const {
        if (path_.empty())
            return;
        try {
            std::error_code failed;
            std::filesystem::create_directories(folder_, failed);
            write_file(path_, key_ + digits(binary) + binary);
        } catch (const Error&) {
        }
    }

  private:
    static constexpr std::size_t hash_digits = 16;
    static std::string digits(const std::string& binary) {
        return fmt::format("{:016x}", hash_bytes(binary));
    }

    std::string folder_;
    std::string path_;
    std::string key_;
};

} // namespace

class Device::Buffer {
  public:
    Buffer(cl_context context, std::size_t bytes) : bytes_(bytes) {
        cl_int status = CL_SUCCESS;
        memory_ = clCreateBuffer(context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, 1),
                                 nullptr, &status);
        if (status != CL_SUCCESS)
            throw Error::resource(
                fmt::format("OpenCL: no memory for {} bytes (error {})", bytes, status));
    }
    ~Buffer() { clReleaseMemObject(memory_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    cl_mem memory() const { return memory_; }
    std::size_t bytes() const { return bytes_; }

  private:
    cl_mem memory_ = nullptr;
    std::size_t bytes_;
};

/// Opened on first use: starting a driver takes tenths of a second, and most runs do not need one.
struct Device::State {
    std::string wanted;
    Found found{};
    cl_context context = nullptr;
    cl_command_queue queue = nullptr;
    std::map<std::string, cl_program> programs; // by source
    std::map<std::pair<cl_program, std::string>, cl_kernel> kernels;

    explicit State(std::string name) : wanted(std::move(name)) {}
    ~State() {
        for (const auto& [key, kernel] : kernels)
            clReleaseKernel(kernel);
        for (const auto& [source, program] : programs)
            clReleaseProgram(program);
        if (queue != nullptr)
            clReleaseCommandQueue(queue);
        if (context != nullptr)
            clReleaseContext(context);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void open() {
        if (queue != nullptr)
            return;
        found = choose_device(wanted);
        cl_int status = CL_SUCCESS;
        if (context == nullptr)
            context = clCreateContext(nullptr, 1, &found.id, nullptr, nullptr, &status);
        check(status, "creating a context");
        queue = clCreateCommandQueue(context, found.id, 0, &status);
        check(status, "creating a queue");
    }

    cl_program build(const std::string& source);
    cl_kernel kernel(const std::string& source, const std::string& name);
};

cl_program Device::State::build(const std::string& source) {
    if (const auto program = programs.find(source); program != programs.end())
        return program->second;
    // Without contraction and with correctly rounded division, results are equal on all devices.
    const char* options = "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt";
    cl_device_fp_config precision = 0;
    clGetDeviceInfo(found.id, CL_DEVICE_SINGLE_FP_CONFIG, sizeof precision, &precision, nullptr);
    if ((precision & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) == 0)
        options = "-cl-std=CL1.2";
    const std::string text = "#pragma OPENCL FP_CONTRACT OFF\n" + source;
    const BinaryCache cache(fmt::format("scree kernel\n{}\n{}\n{}\n{}\n{:016x}\n", found.platform,
                                        found.name, found.driver, options, hash_bytes(text)));

    cl_program program = nullptr;
    cl_int status = CL_SUCCESS;
    if (const std::string binary = cache.load(); !binary.empty()) {
        const std::size_t size = binary.size();
        const auto* bytes = reinterpret_cast<const unsigned char*>(binary.data());
        program = clCreateProgramWithBinary(context, 1, &found.id, &size, &bytes, nullptr, &status);
        if (status == CL_SUCCESS)
            status = clBuildProgram(program, 1, &found.id, options, nullptr, nullptr);
        if (status == CL_SUCCESS)
            return programs[source] = program;
        if (program != nullptr)
            clReleaseProgram(program);
    }

    const char* begin = text.c_str();
    program = clCreateProgramWithSource(context, 1, &begin, nullptr, &status);
    check(status, "reading a kernel");
    status = clBuildProgram(program, 1, &found.id, options, nullptr, nullptr);
    if (status != CL_SUCCESS) {
        std::size_t size = 0;
        clGetProgramBuildInfo(program, found.id, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
        std::string log(size, '\0');
        clGetProgramBuildInfo(program, found.id, CL_PROGRAM_BUILD_LOG, size, log.data(), nullptr);
        log.resize(std::min(log.size(), log.find('\0')));
        clReleaseProgram(program);
        throw Error::resource(fmt::format("OpenCL: {} does not compile a kernel (error {}):\n{}",
                                          found.name, status, log));
    }
    std::size_t size = 0;
    if (clGetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof size, &size, nullptr) ==
            CL_SUCCESS &&
        size > 0) {
        std::string binary(size, '\0');
        auto* bytes = reinterpret_cast<unsigned char*>(binary.data());
        if (clGetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof bytes, &bytes, nullptr) ==
            CL_SUCCESS)
            cache.store(binary);
    }
    return programs[source] = program;
}

cl_kernel Device::State::kernel(const std::string& source, const std::string& name) {
    cl_program program = build(source);
    cl_kernel& kernel = kernels[{program, name}];
    if (kernel == nullptr) {
        cl_int status = CL_SUCCESS;
        kernel = clCreateKernel(program, name.c_str(), &status);
        check(status, ("finding kernel " + name).c_str());
    }
    return kernel;
}

Device::Device(const std::string& name) : state_(std::make_unique<State>(name)) {}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

std::vector<std::string> Device::names() {
    std::vector<std::string> names;
    const std::vector<Found> devices = find_devices();
    for (std::size_t i = 0; i < devices.size(); ++i)
        names.push_back(fmt::format("{}: {} ({} {})", i, devices[i].name, devices[i].platform,
                                    devices[i].driver));
    return names;
}

const std::string& Device::name() const {
    state_->open();
    return state_->found.name;
}

Device::BufferHandle Device::allocate(std::size_t bytes) {
    state_->open();
    return std::make_shared<Buffer>(state_->context, bytes);
}

void Device::write(const BufferHandle& buffer, const void* data, std::size_t bytes) {
    if (bytes > 0)
        check(clEnqueueWriteBuffer(state_->queue, buffer->memory(), CL_TRUE, 0, bytes, data, 0,
                                   nullptr, nullptr),
              "writing to the device");
}

void Device::read(const BufferHandle& buffer, void* data, std::size_t bytes) {
    if (bytes > 0)
        check(clEnqueueReadBuffer(state_->queue, buffer->memory(), CL_TRUE, 0, bytes, data, 0,
                                  nullptr, nullptr),
              "reading from the device");
}

void Device::run(const std::string& source, const std::string& kernel,
                 std::span<const std::size_t> global_size, std::span<const Argument> arguments,
                 std::span<const std::size_t> groups) {
    state_->open();
    const cl_kernel compiled = state_->kernel(source, kernel);
    for (cl_uint i = 0; i < arguments.size(); ++i) {
        const cl_int status = std::visit(
            [&](const auto& value) {
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, BufferHandle>) {
                    const cl_mem memory = value->memory();
                    // OpenCL takes the handle itself: its size is a pointer's.
                    return clSetKernelArg(compiled, i, sizeof(void*), &memory);
                } else {
                    return clSetKernelArg(compiled, i, sizeof value, &value);
                }
            },
            arguments[i]);
        if (status != CL_SUCCESS)
            throw Error::resource(fmt::format("OpenCL: argument {} of kernel {} is refused (error "
                                              "{})",
                                              i, kernel, status));
    }
    check(clEnqueueNDRangeKernel(state_->queue, compiled, static_cast<cl_uint>(global_size.size()),
                                 nullptr, global_size.data(),
                                 groups.empty() ? nullptr : groups.data(), 0, nullptr, nullptr),
          ("starting kernel " + kernel).c_str());
    check(clFinish(state_->queue), ("running kernel " + kernel).c_str());
}

} // namespace scree
