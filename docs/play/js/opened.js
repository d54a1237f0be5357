// Before a page is drawn: the theme that the button of the written pages chose, also when it is chosen elsewhere.
const themed = () => {
  const theme = localStorage.getItem("theme");
  if (theme) document.documentElement.dataset.theme = theme;
};
themed();
addEventListener("storage", themed);

// A page that was opened as a file: browsers start its modules only from a server, so that it says what to do.
if (location.protocol === "file:") {
  addEventListener("DOMContentLoaded", () => {
    document.querySelector("main").innerHTML = "<p class='card'>Opened as a file, this page cannot compute: browsers start the library only from a server. Run <code>./run serve</code> in the project and open <a href='http://localhost:8000'>http://localhost:8000</a>.</p>";
  });
}
