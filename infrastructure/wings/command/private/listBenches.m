% LISTBENCHES  The test rigs that the toolbox brings.
%
% CALL: BENCHES = listBenches (ROOT)
%       BENCHES = listBenches (ROOT, NAMES)
%
%   ROOT     folder of the toolbox (text)
%   NAMES    cell of names: these rigs, in this order (all where it is empty)
%   BENCHES  1 x n struct array: name, folder, title (first line of its README
%            behind the colon), sees, results (see resultInfo), mean and sd (1 x
%            T, of one run at the values of data.head), sizes (1 x s struct
%            array, the variables of the rig, see checkHead), picture (path)
%
% A folder of DEMmodels/ is one where it has results.csv, scatter.csv and
% picture.svg.
%
% Errors: DEcalioc:listBenches:unknownName

function benches = listBenches (root, names)
  files = glob (fullfile (root, 'DEMmodels', '*', 'scatter.csv'));
  benches = [];
  for file = files(:)'
    folder = fileparts (file{1});
    picture = fullfile (folder, 'picture.svg');
    info = resultInfo (folder);
    if isfile (picture) && ~isempty (info)
      [~, name] = fileparts (folder);
      readme = fileread (fullfile (folder, 'README.md'));
      [sd, means] = runScatter (folder);
      benches = [benches, ...
                 struct('name', name, 'folder', folder, ...
                        'title', said (readme, '^# [^:\n]*: ([^\n]*)'), ...
                        'sees', said (readme, '^Sees: ([^\n]*)'), ...
                        'results', info, 'mean', means, 'sd', sd, ...
                        'sizes', sizesOf (folder), ...
                        'picture', picture)];
    end
  end
  if nargin > 1 && ~isempty (names)
    benches = benches(placesOf (names, {benches.name}));
  end
end

function at = placesOf (names, known)
  [isKnown, at] = ismember (names, known);
  if ~all (isKnown)
    unknown = names(~isKnown){1};
    error ('DEcalioc:listBenches:unknownName', ...
           ['The test rigs of the toolbox are %s, got ''%s''. %s ' ...
            'decalioc benches describes them.'], ...
           strjoin (known, ', '), unknown, checkNearest (unknown, known));
  end
end

function text = said (readme, pattern)
  found = regexp (readme, pattern, 'tokens', 'once', 'lineanchors');
  text = [found{:}];
end

% What is left out says how a run is made and read, not what the rig is like.
function sizes = sizesOf (folder)
  head = checkHead (folder);
  text = fileread (fullfile (folder, 'data.head'));
  part = text(strfind (text, '# --- the bench'):end);
  names = regexp (part, '^variable (\S+)', 'tokens', 'lineanchors');
  names = [names{:}];
  names = names(cellfun (@isempty, regexp (names, '^(rest|skip|read|glue)')));
  sizes = head(ismember ({head.name}, names));
end

%!shared root
%! root = fileparts (fileparts (which ('startToolbox')));
%!test
%! benches = listBenches (root);
%! assert ({benches.name}, {'Collapse', 'Doser', 'Drum', 'Heap', 'Shear', ...
%!                         'SlotBin'});
%! heap = benches(4);
%! assert (heap.title, 'heap by a lifted tube');
%! assert ({heap.sizes.name}, {'tubeRadius', 'plateRadius', 'heapSolid', ...
%!                             'liftSpeed', 'liftHeight'});
%! assert (heap.sizes(1).value, '0.015');
%! assert (size (heap.mean), size (heap.results));
%! assert (~any (cellfun (@isempty, {benches.sees})));
%!assert ({listBenches(root, {'Heap', 'Drum'}).name}, {'Heap', 'Drum'})
%!error id=DEcalioc:listBenches:unknownName listBenches (root, {'Drun'})
%!error <got 'Drun'. Did you mean Drum> listBenches (root, {'Heap', 'Drun'})

% SPDX-License-Identifier: GPL-3.0-only
