// The viewer, for viewer.html and notebooks.
import { bundle } from "./vite.bundle.ts";

export default bundle("viewer");
