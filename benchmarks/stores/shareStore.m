% SHARESTORE  Gives a store to a group, and a user what is his.
%
% CALL: shareStore (STORE, USER)
%
%   STORE  folder (text): setgid, its group may write, as docs/next-material.md
%          says;  USER  see userCase
%
% As root the user's folder becomes his, and the group is number 2000; else
% everything belongs to the caller.
%
% See also: twoUsers

function shareStore (store, user)
  if geteuid () == 0
    system (sprintf ('chown -R %d:2000 %s; chgrp 2000 %s', user.uid, ...
                     shellQuote (user.home), shellQuote (store)));
  end
  system (['chmod 2775 ', shellQuote(store)]);
end
