% COPYMODEL  Copies a model into the folder of a run.
%
% CALL: copyModel (FOLDER, SOURCE)
%
% FOLDER  folder of the run (text)
% SOURCE  model folder (text)
%
% Links inside the model folder are followed, so that a run folder holds all
% it needs. What every run writes (log.liggghts, and the files of a run folder)
% is left out: of a trial made by hand in the model folder it would be taken for
% that of the run. Other output there is a fault (leftoverResults).
%
% Errors: DEcalioc:copyModel:cannotWrite

function copyModel (folder, source)
  written = {'log.liggghts', 'stdout.txt', 'stderr.txt', 'pid', 'limit', ...
             'end.mark', 'job.json', 'record.json', 'getResults.late', ...
             'ExPlan.txt'};
  skip = cellfun (@(name) [' ! -path ./', name], written, ...
                  'UniformOutput', false);
  [status, why] = system (['t=$(realpath -- ', shellQuote(folder), ') && ' ...
                           'cd ', shellQuote(source), ' && ', ...
                           'find . -mindepth 1 -maxdepth 1', skip{:}, ...
                           ' -exec cp -rL --remove-destination ' ...
                           '-t "$t" -- {} + 2>&1']);
  if status ~= 0
    error ('DEcalioc:copyModel:cannotWrite', ...
           ['copyModel: %s must take the files of the model, got: %s. Free ' ...
            'some space or correct the permissions and start again; ' ...
            'finished runs are kept.'], folder, strtrim (why));
  end
end

%!error id=DEcalioc:copyModel:cannotWrite copyModel (tempdir (), '/nowhere')
%!test
%! % what a run by hand has left at the top of the model is not copied
%! [model, folder] = deal (tempname (), tempname ());
%! mkdir (model);
%! mkdir (folder);
%! mkdir (fullfile (model, 'meshes'));
%! for name = {'in.M', 'log.liggghts', 'meshes/log.liggghts', '-odd name', ...
%!             'limit', '.hidden'}
%!   writeAtomic (fullfile (model, name{1}), 'x');
%! end
%! symlink (fullfile (model, 'in.M'), fullfile (model, 'stdout.txt'));
%! copyModel (folder, model);
%! assert (setdiff (readdir (folder), {'.', '..'}), ...
%!         {'-odd name'; '.hidden'; 'in.M'; 'meshes'});
%! assert (isfile (fullfile (folder, 'meshes', 'log.liggghts')));

% SPDX-License-Identifier: GPL-3.0-only
