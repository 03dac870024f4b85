% CASENOTES  What of a user's input is no fault, but may be meant otherwise.
%
% CALL: NOTES = caseNotes (RAW, MODELS)
%
%   RAW     input without faults, see newCase
%   MODELS  1 x M struct array with the fields name and folder ('' = none)
%   NOTES   1 x n cell of sentences for the user: fields of Input and optim that
%           nothing here reads (a costFunction of the user's may), models of
%           which no file but data.head uses runSeed
%
% See also: newCase, checkCase, checkFields

function notes = caseNotes (raw, models)
  [~, input] = checkInputFields (raw.Input);
  [~, optim] = checkOptim (raw.optim);
  notes = strcat ([strcat('Input.', input), strcat('optim.', optim)], ...
                  {[' in loadInput.m is read by nothing here, only by ' ...
                    'files of your own']});
  for model = models
    if ~isempty (model.folder) && ~usesSeed (model.folder)
      notes{end + 1} = ['no file of DEMmodels/', model.name, ' uses ' ...
                        'runSeed: all runs of a set are one and the same ' ...
                        'packing, and tell nothing of its scatter. Take ' ...
                        'insertion seeds from ${runSeed} (docs/extend.md)'];
    end
  end
end

% data.head only declares it. Folders linked in a circle end the search.
function yes = usesSeed (folder)
  yes = system (['grep -RIqw --exclude=data.head runSeed ', ...
                 shellQuote(folder), ' 2> /dev/null']) == 0;
end

%!test
%! raw = standInCase (tempname ());
%! raw.Input.colour = 'red';
%! raw.optim.myWeights = [1, 2];
%! Case = newCase (raw);
%! assert (numel (Case.notes), 4);
%! assert (! isempty (strfind (Case.notes{1}, 'Input.colour')));
%! assert (! isempty (strfind (Case.notes{2}, 'optim.myWeights')));
%! assert (! isempty (strfind (Case.notes{3}, 'DEMmodels/First ')));
%! % used in a comment is used, as nobody can tell what a script does
%! for model = {'First', 'Second'}
%!   folder = fullfile (raw.folder, 'DEMmodels', model{1}, 'lib');
%!   mkdir (folder);
%!   writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeed}');
%! end
%! raw.Input = rmfield (raw.Input, 'colour');
%! raw.optim = rmfield (raw.optim, 'myWeights');
%! assert (newCase (raw).notes, cell (1, 0));
%! % a word that holds it is another one; no folder, no note
%! writeAtomic (fullfile (folder, 'insert.in'), 'seed ${runSeeds}');
%! assert (numel (newCase (raw).notes), 1);
%! assert (caseNotes (raw, struct ('name', 'A', 'folder', '')), cell (1, 0));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
