% BLINDCASES  Makes the case folders of a sealed study from its tables.
%
% CALL: FOLDERS = blindCases (STEM, LAB, PLACE)
%
%   STEM     path without ending, as of blindHandOver
%   LAB      struct of blindLab, of which runs, inputs and renamed are read;
%            PLACE gets a copy of the runs, their results named as in
%            results.csv of the benches, so that new runs can follow (blind.m
%            whole)
%   PLACE    folder for the case folders; those that are there stay
%   FOLDERS  1 x N cell of paths: loadInput.m, loadEffects.m, measured.csv and
%            runs.csv, nothing else
%
% See also: blindHandOver, blindAnswer

function folders = blindCases (stem, lab, place)
  values = textOf ([stem, '-cases.csv']);
  lists = textOf ([stem, '-lists.csv']);
  folders = {};
  [~, ~] = mkdir (place);
  shared = fullfile (place, 'runs.csv');
  writeAtomic (shared, renamed (fileread (lab.runs), lab.renamed(:, [1, 2])));
  for i = 1:numel (lists)
    [number, effects] = strtok (lists{i}, ',');
    folder = fullfile (place, ['case', number]);
    folders{end + 1} = folder;
    if isfolder (folder)
      continue
    end
    [~, ~] = mkdir (folder);
    copyfile (lab.inputs, folder);
    names = sprintf (' ''%s''', strsplit (effects(2:end), ' '){:});
    writeAtomic (fullfile (folder, 'loadEffects.m'), ...
                 sprintf (['function effects = loadEffects ()\n', ...
                           '  effects = {%s};\nend\n'], names));
    rows_ = values(strncmp (values, [number, ','], numel (number) + 1));
    rows_ = cellfun (@(line) line(numel (number) + 2:end), rows_, ...
                     'UniformOutput', false);
    text = strjoin ([{'model,name,value,sd,repeats,role'}, rows_, {''}], ...
                    "\n");
    writeAtomic (fullfile (folder, 'measured.csv'), ...
                 renamed (text, lab.renamed(:, [1, 3])));
    symlink (shared, fullfile (folder, 'runs.csv'));
  end
end

% The campaign tells the slopes of two benches apart by names of its own, and
% has the height of the heap under an old one.
function text = renamed (text, names)
  for name = names'
    text = strrep (text, name{:});
  end
end

function lines = textOf (file)
  [~, rest] = originOf (file);
  lines = strsplit (strtrim (rest), "\n")(2:end);
end

%!test % a folder holds what the laboratory hands over; the truth is sealed
%! folder = emptyFolder ();
%! stem = fullfile (folder, 'study');
%! problem = struct ('effects', struct ('name', {'drag', 'shape'}), ...
%!                   'benchNames', {{'Heap'}}, 'bench', [1, 1], ...
%!                   'targetNames', {{'slope', 'height'}}, ...
%!                   'names', {{'mu'}}, 'limits', [0; 1], ...
%!                   'held', [false, true]);
%! lab = struct ('trials', 2, 'sd', [2, 4], 'problem', problem);
%! truth = struct ('number', {1, 2}, 'class', {'null', 'lookAlike'}, ...
%!                 'cause', {{}, {'shape'}}, 'forms', {{}, {'fourSpheres'}}, ...
%!                 'removed', {'', 'shape'}, 'phi', {zeros(1, 0), 0.4}, ...
%!                 'level', {0, 5}, 'theta', {0.1, 0.9}, 'halfStep', ...
%!                 {true, false}, 'seeds', [20011, 20021], ...
%!                 'noise', ones (2));
%! Z = {[1, 2; 3, 4], [5, NaN; 7, 8]};
%! blindHandOver (stem, fullfile (folder, 'truth'), lab, truth, Z);
%! [~, digest] = system (sprintf ('sha256sum %s', fullfile (folder, 'truth')));
%! assert (strtrim (fileread ([stem, '-truth.sha256'])), strtok (digest));
%! cases = fileread ([stem, '-cases.csv']);
%! assert (strfind (cases, '1,Heap,slope,4,1.41421,2,calibrate') > 0);
%! assert (strfind (cases, '2,Heap,height,,2.82843,2,holdout') > 0);
%! writeAtomic (fullfile (folder, 'runs'), "model,heapSlope,heapHeight\n");
%! lab.runs = fullfile (folder, 'runs');
%! lab.inputs = fullfile (fileparts (which ('blindCases')), 'case', ...
%!                        'loadInput.m');
%! lab.renamed = {'heapSlope', 'Heap_slope', 'slope'; ...
%!                'heapHeight', 'height', 'height'};
%! folders = blindCases (stem, lab, fullfile (folder, 'cases'));
%! assert (fileread (fullfile (folders{1}, 'runs.csv')), ...
%!         "model,Heap_slope,height\n");
%! found = setdiff (readdir (folders{2})', {'.', '..'});
%! assert (found, {'loadEffects.m', 'loadInput.m', 'measured.csv', 'runs.csv'});
%! list = fileread (fullfile (folders{2}, 'loadEffects.m'));
%! assert (isempty (strfind (list, 'shape')) && any (strfind (list, 'drag')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
