% SAYEXPORT  Writes all finished runs of a case as a table.
%
% CALL: STATUS = sayExport (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: the path of the table (default results/runs.csv)
%   STATUS  0
%
% Errors: DEcalioc:sayExport:exists, for a file runs.csv of the case itself,
% which the next start would take in
%
% See also: commandMain, exportRuns, gatherRuns

function status = sayExport (root, folder, args)
  [~, words] = commandOptions (args, struct ());
  file = fullfile (folder, 'results', 'runs.csv');
  if isempty (words)
    [~, ~] = mkdir (fullfile (folder, 'results'));
  else
    file = words{1};
  end
  if strcmp (make_absolute_filename (file), fullfile (folder, 'runs.csv'))
    error ('DEcalioc:sayExport:exists', ...
           ['the table cannot be %s: the next start would take it in, and ' ...
            'the runs are in the store already. Take another name.'], file);
  end
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
  n = exportRuns (file, Case, gatherRuns (Case));
  printf ('%d runs  %s\n', n, file);
  status = 0;
end
