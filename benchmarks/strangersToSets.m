% STRANGERSTOSETS  From a script to the first calibrated set: minutes and hand edits.
%
% CALL: octave-cli benchmarks/strangersToSets.m WORK [NUMBERS]
%
%   WORK     folder for the cases, made anew
%   NUMBERS  which of the ten, e.g. 3:5 (default: all)
%
% For each of the ten scripts of strangerModels: decalioc new --script, the edits that
% are left to be made by hand, check, run. A line each: notes of check, edits (places
% in files of the model), DEM runs, minutes of all commands together, the value that
% was sought and what was found.

1;

function sayOne (m)
  started = tic ();
  if ~isempty (m.prepare)
    system (['cd ', shellQuote(m.folder), ' && ', m.prepare]);
  end
  place = fullfile (fileparts (m.folder), 'case');
  [made, out] = startCommand (m.folder, ['new --model M --script ', m.words, ' ../case']);
  for edit = m.edits'
    file = fullfile (place, 'DEMmodels', 'M', edit{1});
    writeAtomic (file, strrep (fileread (file), edit{2}, edit{3}));
  end
  [checked, notes] = startCommand (place, 'check');
  [status, said] = startCommand (place, 'run');
  if any ([made, checked, status])
    printf ("%s%s%s", out, notes, said);
  end
  c = jsondecode (fileread (fullfile (place, 'results', 'calibration.json')));
  names = fieldnames (c.params);
  printf ('| %s | %d | %d | %d | %.1f | %g | %.4g | %d |\n', m.kind, ...
          numel (strfind (notes, 'WARNING')), rows (m.edits), ...
          c.demRuns.plan + c.demRuns.infill + c.demRuns.verify, toc (started) / 60, ...
          m.value, c.params.(names{1}), status);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
words = argv ();
work = make_absolute_filename (words{1});
confirm_recursive_rmdir (false);
[~, ~] = rmdir (work, 's');
printf (['| script | notes of check | edits | runs | minutes | known | found | exit ' ...
         'status |\n|---|---|---|---|---|---|---|---|\n']);
list = strangerModels (work);
if numel (words) > 1
  ends = sscanf (words{2}, '%d:%d');
  list = list(ends(1):ends(end));
end
arrayfun (@sayOne, list);
