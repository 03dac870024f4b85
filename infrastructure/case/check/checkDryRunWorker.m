% CHECKDRYRUNWORKER  Calls a model's getResults on a folder without a run.
%
% CALL: checkDryRunWorker ()
%
% For the Octave that checkFindModels starts in a folder of its own. The
% environment holds DECALIOC_DRY_MODEL (model folder) and DECALIOC_DRY_NAME
% (its name). What was found goes to the file answer: the number of results
% or NaN, and below it why getResults can never work.

function checkDryRunWorker ()
  %| pragma Justify (metric, "globals", "getResults of users read it");
  global path
  path = [pwd(), '/'];
  model = getenv ('DECALIOC_DRY_MODEL');
  name = getenv ('DECALIOC_DRY_NAME');
  addpath (fullfile (model, 'OctaveFuns'));
  [~, ~] = mkdir (fullfile ('optim', name, 'empty'));
  sample = fullfile (model, 'sample');
  count = NaN;
  text = '';
  if isfolder (sample)
    copy = fullfile ('optim', name, 'sample');     % copyfile runs names: $(x)
    system (['cp -rL -- ', shellQuote(sample), ' ', shellQuote(copy)]);
    [count, ~, fields] = callOnce (name, 'sample');
  end
  if isnan (count)
    [count, text, fields] = callOnce (name, 'empty');
  end
  writeAtomic ([path, 'answer'], ...
               sprintf ("%g\n%s\n%s\n", count, text, ...
                        strjoin ([fields, {''}], ' ')));
end

function [count, text, fields] = callOnce (name, folder)
  text = '';
  fields = {};
  try
    results = getResults (name, folder);
    count = numel (results);
    if isstruct (results)
      fields = fieldnames (results)';
      count = numel (fields);
    end
  catch err
    count = NaN;
    text = lasting (err.message);
  end
end

% Only a fault that does not come from the missing files is worth telling.
function text = lasting (message)
  text = '';
  marks = {'parse error', 'called with too many', 'invalid use of script'};
  if any (cellfun (@(m) ~isempty (strfind (message, m)), marks))
    text = strrep (message, "\n", ' ');
  end
end
