#include "prover/system/sha256.h"

#include <openssl/evp.h>
#include <stdexcept>

namespace plprove {

std::string sha256(const std::string& content) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    std::size_t size = 0;
    if (EVP_Q_digest(nullptr, "SHA256", nullptr, content.data(), content.size(), digest, &size) !=
        1)
        throw std::runtime_error("SHA-256 is not available");
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 0; i < size; ++i) {
        text += digits[digest[i] >> 4];
        text += digits[digest[i] & 15];
    }
    return text;
}

} // namespace plprove
