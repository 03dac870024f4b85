% MAKEPLATES  Writes the two floor plates of the slot bins as STL files.
%
% CALL: makePlates (FOLDER, WIDTH)
%
% FOLDER  text; plateLeft.stl and plateRight.stl are written there
% WIDTH   along y, from 0 (m)
%
% Each plate is 0.06 m long, lies at z = 0 and ends at x = 0; the input script
% moves it to the edge of the slot. Made with makePlates ('.', 0.012).
%
% See also: writeStl
function makePlates (folder, width)
  plate = @(x) cat (3, [0, x, x; 0, 0, width; 0, 0, 0], ...
                    [0, x, 0; 0, width, width; 0, 0, 0]);
  writeStl (fullfile (folder, 'plateLeft.stl'), plate (-0.06));
  writeStl (fullfile (folder, 'plateRight.stl'), plate (0.06));
end
