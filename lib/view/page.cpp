#include "view/page.hpp"

#include "view/text.hpp"

namespace soft::view {

std::string html_page(std::string_view title, std::string_view style, std::string_view body, std::string_view script) {
    const std::string name = escaped(title);
    std::string page = "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n";
    page +=
        "<meta http-equiv='Content-Security-Policy' content=\"default-src 'none'; img-src data:; style-src "
        "'unsafe-inline'; script-src '" +
        policy_hash(script) + "'\">\n";
    page += "<meta name='viewport' content='width=device-width, initial-scale=1'>\n<link rel='icon' href='data:,'>\n";
    page.append("<title>").append(name).append("</title>\n<style>").append(style).append("</style>\n</head>\n<body>\n");
    page.append("<h1>").append(name).append("</h1>\n").append(body);
    if (!script.empty()) page.append("<script>").append(script).append("</script>\n");
    return page + "</body>\n</html>\n";
}

}  // namespace soft::view
