#pragma once
// Writing a finished file: the old content or the whole new one, never a part.

#include <optional>
#include <string>
#include <string_view>

namespace lancer::image {

/// What is wrong, as one line without a full stop: "cannot write out/a.png: there is no folder out".
using WriteError = std::string;

/// Makes `bytes` the content of the file at `path`. Links are followed to what they point at. A regular or a
/// new file is written beside its place under a name of its own, flushed to the disk and moved over; the old
/// file's permissions stay. On any failure the old file is as it was and nothing is left behind. Devices,
/// pipes and the like are written directly. Nothing is returned when all went well.
std::optional<WriteError> write_file_atomically(const std::string& path, std::string_view bytes);

/// Whether write_file_atomically() could begin, to fail before the work and not after: the folder is there
/// and may be written to, the path is no folder and no write-protected file. Changes nothing. Nothing is
/// returned when it could.
std::optional<WriteError> can_write(const std::string& path);

}  // namespace lancer::image
