// <script src="…/play/embed.js"></script> puts the moving curve where the tag stands, as high as what it shows; with
// data-caption="…" these words above it, with data-page="de-boor" the triangle of de Boor in its place,
// with data-view="short" without what comes after the first answer.
{
  const tag = document.currentScript;
  if (location.protocol === "file:") {
    const said = document.createElement("p");
    said.textContent = "Opened as a file, this page cannot compute: browsers start the library only from a server. Run ./run serve in the project and open http://localhost:8000.";
    tag.replaceWith(said);
  } else {
    const frame = document.createElement("iframe");
    frame.src = new URL(`${tag.dataset.page ?? "curve"}.html?embed${tag.dataset.view ? `=${tag.dataset.view}` : ""}${tag.dataset.curve ? `#${tag.dataset.curve}` : ""}`, tag.src);
    frame.title = tag.dataset.page === "de-boor" ? "de Boor’s triangle" : "a curve, exactly";
    frame.loading = "lazy";
    frame.style.cssText = `width:100%;border:0;height:${tag.dataset.height ?? 640}px`;
    addEventListener("message", ({ source, data }) => {
      if (source === frame.contentWindow && !tag.dataset.height && Number.isFinite(data?.exactspline)) frame.style.height = `${data.exactspline}px`;
    });
    const caption = document.createElement("p");
    caption.textContent = tag.dataset.caption ?? "";
    tag.replaceWith(...(caption.textContent ? [caption, frame] : [frame]));
  }
}
