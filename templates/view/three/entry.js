// What the viewer uses of three.js; `npm run build` bundles it, and nothing else, into three.min.js.
export {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DataTexture,
  DirectionalLight, DoubleSide, Float32BufferAttribute, FloatType, Group, HemisphereLight, Line, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshPhongMaterial, NearestFilter, PerspectiveCamera, Quaternion,
  RGBAFormat, Scene, SphereGeometry, SRGBColorSpace, Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
