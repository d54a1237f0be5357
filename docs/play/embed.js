// <script src="…/play/embed.js" data-height="560"></script> puts the moving curve where the tag stands.
const tag = document.currentScript;
const frame = document.createElement("iframe");
frame.src = new URL(`curve.html?embed${tag.dataset.curve ? `#${tag.dataset.curve}` : ""}`, tag.src);
frame.title = "a curve, exactly";
frame.loading = "lazy";
frame.style.cssText = `width:100%;border:0;height:${tag.dataset.height ?? 640}px`;
tag.replaceWith(frame);
