% COPYMODEL  Copies a model into the folder of a run.
%
% CALL: copyModel (FOLDER, SOURCE)
%
% FOLDER  folder of the run (text)
% SOURCE  model folder (text)
%
% Links inside the model folder are followed, so that a run folder holds all
% it needs.
%
% Errors: DEcalioc:copyModel:cannotWrite

function copyModel (folder, source)
  [status, why] = system (['cp -rL --remove-destination ', shellQuote([source, '/.']), ' ', ...
                           shellQuote([folder, '/']), ' 2>&1']);
  if status ~= 0
    error ('DEcalioc:copyModel:cannotWrite', ...
           ['copyModel: %s must take the files of the model, got: %s. Free ' ...
            'some space or correct the permissions and start again; ' ...
            'finished runs are kept.'], folder, strtrim (why));
  end
end

%!error id=DEcalioc:copyModel:cannotWrite copyModel (tempdir (), '/nowhere')
