% TELLAPART  What is known to tell effects of one family from each other.
%
% CALL: TEXT = tellApart (NAMES)
%
%   NAMES  cellstr, names of effects that the data leave open
%   TEXT   one instruction for each family that holds one of them, '' without
%
% The families are those of docs/effects.md: of each one member, the others look
% alike on most benches.

function text = tellApart (names)
  known = {{'rolling', 'shape'}, ...
           ['measure the bulk density: clumps pack denser, rolling ' ...
            'friction looser']; ...
           {'cohesion', 'liquidBridge', 'wallAdhesion'}, ...
           ['repeat a test after a rest (moisture, charge), or along a ' ...
            'smooth wall']; ...
           {'sizeSpread', 'meanSize'}, 'measure a series of openings'; ...
           {'tilt', 'cameraRoll'}, ...
           'put a level on the camera, or turn the test round'; ...
           {'moistDensity', 'gain'}, ...
           'put a reference weight on the balance'};
  parts = {};
  for i = 1:rows (known)
    if any (ismember (names, known{i, 1}))
      parts{end + 1} = sprintf ('%s: %s', strjoin (known{i, 1}, ', '), ...
                                known{i, 2});
    end
  end
  text = strjoin (parts, '; ');
end

%!assert (tellApart ({'drag'}), '')
%!test
%! text = tellApart ({'cohesion', 'gain'});
%! assert (numel (strfind (text, ';')), 1);
%! assert (! isempty (strfind (text, 'after a rest')));
