% HITUSER  An event of twoUsers hits the case of one of the users.
%
% CALL: [USER, SAID] = hitUser (USER, KIND, SEEN)
%
%   USER  scalar struct, see userCase; hit: when it was killed or cancelled (s)
%   KIND  'kill', 'cancel', 'forget' or 'change', see twoUsers; 'back':
%         measured.csv is what it was
%   SEEN  see storeWatch
%   SAID  what the command said (text); begins with FAULT where it should not
%
% See also: twoUsers, asUser

function [user, said] = hitUser (user, kind, seen)
  said = '';
  switch kind
    case 'kill'
      system (sprintf ('pkill -KILL -s %d', user.pid));
      user.hit = time ();
    case 'cancel'
      [status, out] = asUser (user, 'cancel');
      said = saidOf (status, out, '');
      user.hit = time ();
      pause (2);                         % for the shell that waits for it
      if ~isempty (processStart (user.pid))
        said = ['FAULT: it works on. ', said];
      end
    case 'forget'
      [status, out] = asUser (user, forgetWords (user, seen));
      said = saidOf (status, out, 'must be named');
    case 'change'
      how = {'values', 'points', 'remark', 'back'};
      user = changed (user, how{randi(4)});
      said = sprintf ('%d places', user.points);
    case 'back'
      user = changed (user, 'back');
  end
end

% ALLOWED: a refusal that is none of a fault
function said = saidOf (status, out, allowed)
  said = strtok (strtrim (out), "\n");
  if status ~= 0 && (isempty (allowed) || isempty (strfind (out, allowed)))
    said = ['FAULT: ', said];
  end
  said = strrep (said, ',', ';');
end

function words = forgetWords (user, seen)
  models = {'First', 'Second'};
  model = models{randi(2)};
  own = seen(strcmp ({seen.owner}, caseId (user.folder)));
  [~, names] = cellfun (@fileparts, {own.folder}, 'UniformOutput', false);
  words = sprintf ('forget %s %s --case %s', shellQuote (user.store), model, ...
                   shellQuote (user.folder));
  how = randi (3);
  if how == 2
    words = [words, ' --back'];
  elseif how == 3 && ~isempty (own)
    i = randi (numel (own));
    [~, model] = fileparts (fileparts (own(i).folder));
    words = sprintf ('forget %s %s %s', shellQuote (user.store), model, ...
                     names{i});
  end
end

function user = changed (user, how)
  [factor, remark] = deal (1, '');
  user.points = 3;
  switch how
    case 'values'
      factor = 0.95 + 0.1 * rand ();
    case 'points'
      user.points = 4;
    case 'remark'
      remark = "# read once more\n";
  end
  writeAtomic (fullfile (user.folder, 'measured.csv'), ...
               userCase (factor * user.truth, user.points, remark));
  shareStore (user.store, user);
end
