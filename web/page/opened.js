// A classic script, since modules do not run in a page that was opened as a file: says so.
addEventListener("DOMContentLoaded", () => {
  document.getElementById("from-a-file").hidden = location.protocol !== "file:";
});
