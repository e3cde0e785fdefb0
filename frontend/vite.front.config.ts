// The page of a search, front.html.
import { bundle } from "./vite.bundle.ts";

export default bundle("front");
