"""Serves a folder on this machine, compressed by gzip; a file that the browser has already is not sent again.
The engine's files are compressed already.

    python3 server.py FOLDER [PORT]

Each file is read and compressed once, when it is first asked for and whenever it has changed. Port 0 takes a free one.
"""

import gzip
import hashlib
import sys
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlsplit

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".engine": "application/octet-stream",
    ".svg": "image/svg+xml",
    ".webmanifest": "application/manifest+json",
}


class Files:
    """The files of a folder, each with its compressed text and a tag that names its content."""

    def __init__(self, folder):
        self.folder = folder.resolve()
        self.known = {}

    def get(self, path):
        """Content, compressed content (if it is not compressed already), tag and type of the file behind a path; None where there is none."""
        name = unquote(urlsplit(path).path)
        file = (self.folder / name.lstrip("/")).resolve()
        if file.is_dir():
            file = file / "index.html"
        if not file.is_file() or not file.is_relative_to(self.folder):
            return None
        stamp = (file.stat().st_mtime_ns, file.stat().st_size)
        if self.known.get(file, (None,))[0] != stamp:
            content = file.read_bytes()
            tag = '"' + hashlib.sha256(content).hexdigest()[:32] + '"'
            kind = TYPES.get(file.suffix, "text/plain; charset=utf-8")
            compressed = None if file.suffix == ".engine" else gzip.compress(content, 9)
            self.known[file] = (stamp, content, compressed, tag, kind)
        return self.known[file][1:]


class Handler(BaseHTTPRequestHandler):
    """Answers GET and HEAD."""

    protocol_version = "HTTP/1.1"
    files = None

    def do_GET(self):
        self.answer(with_content=True)

    def do_HEAD(self):
        self.answer(with_content=False)

    def answer(self, with_content):
        found = self.files.get(self.path)
        if found is None:
            self.send_error(404)
            return
        content, compressed, tag, kind = found
        if self.headers.get("If-None-Match") == tag:
            self.send_response(304)
            self.common(tag)
            self.end_headers()
            return
        squeezed = compressed is not None and "gzip" in self.headers.get("Accept-Encoding", "")
        body = compressed if squeezed else content
        self.send_response(200)
        self.common(tag)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        if squeezed:
            self.send_header("Content-Encoding", "gzip")
        self.end_headers()
        if with_content:
            self.wfile.write(body)

    def common(self, tag):
        self.send_header("ETag", tag)
        # The browser asks whether its copy is still right.
        self.send_header("Cache-Control", "no-cache")
        self.send_header("Vary", "Accept-Encoding")

    def log_message(self, *_):
        """Says nothing of each request."""


def main():
    if len(sys.argv) not in (2, 3) or not Path(sys.argv[1]).is_dir():
        sys.exit("usage: python3 server.py FOLDER [PORT]")
    Handler.files = Files(Path(sys.argv[1]))
    port = int(sys.argv[2]) if len(sys.argv) == 3 else 8000
    try:
        server = ThreadingHTTPServer(("127.0.0.1", port), Handler)
    except OSError as error:
        sys.exit(f"error: port {port}: {error.strerror}; choose another with PORT=8001 web/serve")
    print(f"http://localhost:{server.server_address[1]}", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
